/* The few functions of CUDA's driver that compare.py calls, for device code translated into C: threads run one after
 * the other, memory of the device is that of the host. A module is taken as loaded whatever it is given. */
#include "driver.h"
#include <stdlib.h>
#include <string.h>

enum { OK = 0, NOT_FOUND = 500 };
struct thread thread;

int cuInit(unsigned flags) { return OK; }
int cuDeviceGet(int *device, int ordinal) { return *device = 0, OK; }
int cuDeviceGetName(char *name, int room, int device) {
  strncpy(name, "the device code translated into C", room);
  return OK;
}
int cuDevicePrimaryCtxRetain(void **context, int device) { return *context = &thread, OK; }
int cuCtxSetCurrent(void *context) { return OK; }
int cuCtxSynchronize(void) { return OK; }
int cuModuleLoadData(void **module, const void *image) { return *module = &thread, OK; }

int cuModuleGetFunction(void **function, void *module, const char *name) {
  for (const struct program *program = programs; program->name; program++)
    if (strcmp(program->name, name) == 0) return *function = (void *)program, OK;
  return NOT_FOUND;
}

int cuMemAlloc_v2(uint64_t *place, size_t bytes) { return *place = (uint64_t)malloc(bytes), OK; }
int cuMemFree_v2(uint64_t place) { return free((void *)place), OK; }
int cuMemcpyHtoD_v2(uint64_t to, const void *from, size_t bytes) { return memcpy((void *)to, from, bytes), OK; }
int cuMemcpyDtoH_v2(void *to, uint64_t from, size_t bytes) { return memcpy(to, (void *)from, bytes), OK; }

int cuLaunchKernel(void *function, unsigned blocks, unsigned y, unsigned z, unsigned threads, unsigned ty, unsigned tz,
                   unsigned shared, void *stream, void **parameters, void **extra) {
  const struct program *program = function;
  thread.ntid = threads;
  for (thread.ctaid = 0; thread.ctaid < blocks; thread.ctaid++)
    for (thread.tid = 0; thread.tid < threads; thread.tid++) program->run(parameters);
  return OK;
}
int cuGetErrorString(int code, const char **text) {
  *text = code == NOT_FOUND ? "not found" : "an error";
  return OK;
}
