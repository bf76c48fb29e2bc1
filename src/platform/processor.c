// SPDX-License-Identifier: MIT
// processor.c -- returns cores, memory, time and vector instructions of the processor; sets its floating-point mode.
#define _GNU_SOURCE // declares sched_getaffinity and clock_gettime; ignored on other systems
#include "platform/processor.h"
#include <fenv.h>
#ifdef _WIN32
#define WIN32_LEAN_AND_MEAN
#include <windows.h>
#else
#include <time.h>
#include <unistd.h>
#endif
#ifdef __linux__
#include <sched.h>
#endif

#if defined(__x86_64__) || defined(__i386__)
#define X86 1
#include <xmmintrin.h>
#else
#define X86 0
#endif

int processor_cores(void)
{
#ifdef _WIN32
	SYSTEM_INFO info;
	GetSystemInfo(&info);
	return (int)info.dwNumberOfProcessors;
#else
#ifdef __linux__
	cpu_set_t set;
	if (sched_getaffinity(0, sizeof(set), &set) == 0)
		return CPU_COUNT(&set);
#endif
	long cores = sysconf(_SC_NPROCESSORS_ONLN);
	return cores > 1 ? (int)cores : 1;
#endif
}

uint64_t processor_memory(void)
{
#ifdef _WIN32
	MEMORYSTATUSEX status = {.dwLength = sizeof(status)};
	return GlobalMemoryStatusEx(&status) ? status.ullTotalPhys : 0;
#else
	long pages = sysconf(_SC_PHYS_PAGES), bytes = sysconf(_SC_PAGESIZE);
	return pages > 0 && bytes > 0 ? (uint64_t)pages * (uint64_t)bytes : 0;
#endif
}

double processor_milliseconds(void)
{
#ifdef _WIN32
	LARGE_INTEGER ticks, frequency;
	QueryPerformanceCounter(&ticks);
	QueryPerformanceFrequency(&frequency);
	return (double)ticks.QuadPart * 1e3 / (double)frequency.QuadPart;
#else
	struct timespec time;
	clock_gettime(CLOCK_MONOTONIC, &time);
	return (double)time.tv_sec * 1e3 + (double)time.tv_nsec * 1e-6;
#endif
}

void processor_sleep(double milliseconds)
{
#ifdef _WIN32
	Sleep((DWORD)(milliseconds + 0.5));
#else
	long nanoseconds = (long)(milliseconds * 1e6);
	nanosleep(&(struct timespec){nanoseconds / 1000000000, nanoseconds % 1000000000}, NULL);
#endif
}

// SCREE_LANES is the sum of the numbers of lanes in this build, which are powers of two.
bool processor_lanes_compiled(int lanes) { return (SCREE_LANES & lanes) != 0; }

bool processor_has_lanes(int lanes)
{
	if (!processor_lanes_compiled(lanes))
		return false;
	switch (lanes)
	{
	case 1:
	case 4:
		return true;
#if X86
	case 8:
		return __builtin_cpu_supports("avx2");
	case 16:
		return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
		       __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw");
#else
	// the compiler splits vectors that are wider than those of the processor
	case 8:
	case 16:
		return true;
#endif
	}
	return false;
}

int processor_widest_lanes(void)
{
#if X86
	int lanes = 16;
#else
	int lanes = 4;
#endif
	while (lanes > 1 && !processor_has_lanes(lanes))
		lanes /= 2;
	return lanes;
}

const char* processor_instructions(int lanes)
{
	if (lanes == 1)
		return "scalar";
#if X86
	return lanes == 16 ? "AVX-512" : lanes == 8 ? "AVX2" : "SSE2";
#elif defined(__aarch64__)
	return "NEON";
#else
	return "plain";
#endif
}

// These functions are not inlined, so that a compiler does not move float operations across the change of the mode.
#define MODE_CALL __attribute__((noinline))

#if X86

#define MXCSR_DEFAULT 0x1f80u // all exceptions masked, round to nearest, neither FTZ nor DAZ
#define MXCSR_RAISED  0x3fu   // flags of exceptions that occurred, which are no part of the mode

MODE_CALL FloatMode float_mode_enter(void)
{
	FloatMode found = _mm_getcsr();
	if ((found & ~MXCSR_RAISED) != MXCSR_DEFAULT)
		_mm_setcsr(MXCSR_DEFAULT);
	return found;
}

// Writes the register only if the mode differs, because every call of the library ends here and writing takes longer
// than reading.
MODE_CALL void float_mode_leave(FloatMode found)
{
	if ((found & ~MXCSR_RAISED) != (_mm_getcsr() & ~MXCSR_RAISED))
		_mm_setcsr((unsigned)found);
}
void float_mode_flush(void) { _mm_setcsr(MXCSR_DEFAULT | 0x8040u); } // FTZ, DAZ

#elif defined(__aarch64__)

MODE_CALL FloatMode float_mode_enter(void)
{
	FloatMode found, plain = 0; // round to nearest; FZ, FZ16 and traps off
	__asm__ volatile("mrs %0, fpcr" : "=r"(found));
	__asm__ volatile("msr fpcr, %0" : : "r"(plain));
	return found;
}

MODE_CALL void float_mode_leave(FloatMode found) { __asm__ volatile("msr fpcr, %0" : : "r"(found)); }
void float_mode_flush(void) { float_mode_leave(1u << 24); } // FZ

#elif defined(__arm__) && defined(__ARM_FP)

MODE_CALL FloatMode float_mode_enter(void)
{
	uint32_t found, plain = 0; // round to nearest; flush-to-zero, default NaN and traps off
	__asm__ volatile("vmrs %0, fpscr" : "=r"(found));
	__asm__ volatile("vmsr fpscr, %0" : : "r"(plain));
	return found;
}

MODE_CALL void float_mode_leave(FloatMode found) { __asm__ volatile("vmsr fpscr, %0" : : "r"((uint32_t)found)); }
void float_mode_flush(void) { float_mode_leave(1u << 24); } // FZ

#elif defined(__wasm__)

FloatMode float_mode_enter(void) { return 0; }
void float_mode_leave(FloatMode found) { (void)found; }
void float_mode_flush(void) {}

#else

// Other processors have no mode that flushes denormals, or it is not in use on Linux; the rounding remains.
MODE_CALL FloatMode float_mode_enter(void)
{
	int found = fegetround();
	if (found != FE_TONEAREST)
		fesetround(FE_TONEAREST);
	return (FloatMode)found;
}

MODE_CALL void float_mode_leave(FloatMode found)
{
	if ((int)found != fegetround())
		fesetround((int)found);
}

void float_mode_flush(void) {}

#endif

void float_mode_end(const FloatMode* found) { float_mode_leave(*found); }
