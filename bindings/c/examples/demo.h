/* What the two programs share: a demonstration and a digest; each program brings its own `put`. */
#ifndef DEMO_H
#define DEMO_H

#include <stdint.h>

/* Writes text to wherever the program writes. */
void put(const char *text);

/* A puck, a joint and a ball. */
void demonstrate(void);

/* One number for the bits of all that the library computes, by FNV-1a. */
uint64_t digest(void);

/* Writes the digest as 16 hexadecimal digits and ends the line. */
void put_digest(uint64_t hash);

#endif
