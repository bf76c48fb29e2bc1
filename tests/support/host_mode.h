// SPDX-License-Identifier: MIT
// host_mode.h -- sets the floating-point mode that a host program may have when it calls the library.
#ifndef HOST_MODE_H
#define HOST_MODE_H
#include <fenv.h>
#include <stdbool.h>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

// Rounds up, and on x86 and ARM replaces denormal results and operands by zero.
static inline void host_mode_enter(void)
{
	fesetround(FE_UPWARD);
#if defined(__SSE2__)
	_mm_setcsr(_mm_getcsr() | 0x8040u); // flush-to-zero, denormals-are-zero
#elif defined(__aarch64__)
	unsigned long mode;
	__asm__ volatile("mrs %0, fpcr" : "=r"(mode));
	__asm__ volatile("msr fpcr, %0" : : "r"(mode | 1ul << 24)); // FZ
#elif defined(__arm__)
	unsigned mode;
	__asm__ volatile("vmrs %0, fpscr" : "=r"(mode));
	__asm__ volatile("vmsr fpscr, %0" : : "r"(mode | 1u << 24)); // FZ
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
#elif defined(__arm__)
	unsigned mode;
	__asm__ volatile("vmrs %0, fpscr" : "=r"(mode));
	__asm__ volatile("vmsr fpscr, %0" : : "r"(mode & ~(1u << 24)));
#endif
}

// Unmasks all traps except for inexact results, if the processor has them. Returns false if not.
static inline bool host_traps_enter(void)
{
#if defined(__SSE2__)
	_mm_setcsr((_mm_getcsr() & ~0x0fbfu)); // masks and flags of invalid, denormal, zero divide, overflow, underflow
	return true;
#else
	return false;
#endif
}

// Masks the traps again. Returns whether they were unmasked.
static inline bool host_traps_leave(void)
{
#if defined(__SSE2__)
	bool unmasked = (_mm_getcsr() & 0x0f80u) == 0;
	_mm_setcsr(_mm_getcsr() | 0x0f80u);
	return unmasked;
#else
	return false;
#endif
}

#endif
