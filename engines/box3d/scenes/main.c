#include "cost.h"
#include "rest.h"
#include "throws.h"

#include <stdio.h>
#include <string.h>

int main( int count, char** arguments )
{
	const char* scene = count == 2 ? arguments[1] : "";
	if ( strcmp( scene, "throws" ) == 0 )
	{
		print_throws();
	}
	else if ( strcmp( scene, "rest" ) == 0 )
	{
		print_rest();
	}
	else if ( strcmp( scene, "pile" ) == 0 )
	{
		printf( "%.2f\n", pile_microseconds() );
	}
	else if ( strcmp( scene, "sliding" ) == 0 )
	{
		printf( "%.2f\n", sliding_microseconds() );
	}
	else
	{
		fprintf( stderr, "usage: %s throws|rest|pile|sliding\n"
						 "throws and rest print CSV, pile and sliding the CPU time of a step in microseconds\n",
				 arguments[0] );
		return 2;
	}
	return 0;
}
