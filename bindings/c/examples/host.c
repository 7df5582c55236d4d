/* The demonstration on a computer. */
#include "demo.h"

#include <stdio.h>

void put(const char *text)
{
    fputs(text, stdout);
}

int main(void)
{
    demonstrate();
    put_digest(digest());
    return 0;
}
