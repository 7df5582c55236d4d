/*
 * The demonstration on a Cortex-M4F without operating system or C library: start-up code and text
 * through semihosting. Runs under qemu-system-arm -M mps2-an386.
 */
#include "demo.h"

/* From board.ld. */
extern uint32_t stack_top, data_start, data_end, data_image, bss_start, bss_end;

/* Semihosting calls: write a text, exit. */
enum { SYS_WRITE0 = 0x04, SYS_EXIT = 0x18, APPLICATION_EXIT = 0x20026, FAULT = 0x20023 };

static void semihost(uint32_t operation, uintptr_t argument)
{
    register uint32_t r0 __asm__("r0") = operation;
    register uintptr_t r1 __asm__("r1") = argument;

    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
}

void put(const char *text)
{
    semihost(SYS_WRITE0, (uintptr_t)text);
}

static void fault(void)
{
    put("fault\n");
    semihost(SYS_EXIT, FAULT);
    for (;;) {
    }
}

void start(void)
{
    volatile uint32_t *coprocessors = (volatile uint32_t *)0xe000ed88;
    uint32_t *from = &data_image, *to;

    /* The floating-point unit is off after reset. */
    *coprocessors |= 0xfu << 20;
    __asm__ volatile("dsb\n isb");
    for (to = &data_start; to < &data_end;) {
        *to++ = *from++;
    }
    for (to = &bss_start; to < &bss_end;) {
        *to++ = 0;
    }
    demonstrate();
    put_digest(digest());
    semihost(SYS_EXIT, APPLICATION_EXIT);
    for (;;) {
    }
}

/* Initial stack pointer, reset, and the faults. */
__attribute__((section(".vectors"), used)) static const uintptr_t vectors[] = {
    (uintptr_t)&stack_top, (uintptr_t)start, (uintptr_t)fault, (uintptr_t)fault,
    (uintptr_t)fault,      (uintptr_t)fault, (uintptr_t)fault,
};
