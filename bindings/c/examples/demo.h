/* Shared by both programs: a demonstration and a digest. Each program defines its own `put`. */
#ifndef DEMO_H
#define DEMO_H

#include <stdint.h>

/* Writes text to the output of the program. */
void put(const char *text);

/* A puck, a joint and a ball. */
void demonstrate(void);

/* FNV-1a hash of the bits of all results of the library. */
uint64_t digest(void);

/* Writes the digest as 16 hexadecimal digits and ends the line. */
void put_digest(uint64_t hash);

#endif
