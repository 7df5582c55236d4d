/* Between driver.c and the translated device code. */
#include <stdint.h>

/* Numbers of this thread, of the threads in a block, and of its block. */
struct thread {
  uint32_t tid, ntid, ctaid;
};
extern struct thread thread;

/* A program with the addresses of its parameters. The list ends without a name. */
struct program {
  const char *name;
  void (*run)(void **parameters);
};
extern const struct program programs[];
