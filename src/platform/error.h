// SPDX-License-Identifier: MIT
// error.h -- the last error's sentence, and what goes through scree_hooks: the log, memory, assertions.
#ifndef ERROR_H
#define ERROR_H
#include "scree/scree.h"

#if defined(__GNUC__)
#define FORMAT(a, b) __attribute__((format(printf, a, b)))
#else
#define FORMAT(a, b)
#endif

// sets the sentence of scree_error on this thread and returns status
scree_status fail(scree_status status, const char* format, ...) FORMAT(2, 3);

// returns the status from the enclosing function, unless it is SCREE_OK
#define TRY(expression)                         \
	do                                          \
	{                                           \
		scree_status try_status = (expression); \
		if (try_status != SCREE_OK)             \
			return try_status;                  \
	} while (0)

// passes one sentence to the log hook
void log_sentence(scree_log_level level, const char* format, ...) FORMAT(2, 3);

// memory from the allocator hook, aligned to 64 bytes, zeroed; null when there is none. bytes may be 0.
void* scree_allocate(size_t bytes);
// keeps the first old_bytes, zeroes the rest; null (and memory untouched) when there is none
void* scree_reallocate(void* memory, size_t old_bytes, size_t bytes);
void scree_release(void* memory); // null is allowed

void assert_failed(const char* expression, const char* file, int line);
#define ASSERT(x) ((x) ? (void)0 : assert_failed(#x, __FILE__, __LINE__))

// counts worlds: hooks cannot change while one exists
void worlds_add(int change);

#endif
