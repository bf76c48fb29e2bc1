// SPDX-License-Identifier: MIT
// host_mode.h -- sets the floating-point mode that a host program may have when it calls the library.
#ifndef HOST_MODE_H
#define HOST_MODE_H
#include <fenv.h>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

// Rounds up, and on x86 and ARM64 replaces denormal results and operands by zero.
static inline void host_mode_enter(void)
{
	fesetround(FE_UPWARD);
#if defined(__SSE2__)
	_mm_setcsr(_mm_getcsr() | 0x8040u); // flush-to-zero, denormals-are-zero
#elif defined(__aarch64__)
	unsigned long mode;
	__asm__ volatile("mrs %0, fpcr" : "=r"(mode));
	__asm__ volatile("msr fpcr, %0" : : "r"(mode | 1ul << 24)); // FZ
#endif
}

static inline void host_mode_leave(void)
{
	fesetround(FE_TONEAREST);
#if defined(__SSE2__)
	_mm_setcsr(_mm_getcsr() & ~0x8040u);
#elif defined(__aarch64__)
	unsigned long mode;
	__asm__ volatile("mrs %0, fpcr" : "=r"(mode));
	__asm__ volatile("msr fpcr, %0" : : "r"(mode & ~(1ul << 24)));
#endif
}

#endif
