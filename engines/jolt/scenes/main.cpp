#include "cost.h"
#include "rest.h"
#include "throws.h"
#include "world.h"

#include <cstdio>
#include <string_view>

int main(int inCount, char **inArguments)
{
	std::string_view scene = inCount == 2? inArguments[1] : "";
	InitialiseEngine();
	if (scene == "throws")
		PrintThrows();
	else if (scene == "rest")
		PrintRest();
	else if (scene == "pile")
		std::printf("%.2f\n", PileMicroseconds());
	else if (scene == "sliding")
		std::printf("%.2f\n", SlidingMicroseconds());
	else
	{
		std::fprintf(stderr, "usage: %s throws|rest|pile|sliding\n"
							 "throws and rest print CSV, pile and sliding the CPU time of a step in microseconds\n", inArguments[0]);
		return 2;
	}
	return 0;
}
