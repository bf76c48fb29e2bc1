// SPDX-License-Identifier: MIT
// error.h -- declares the last error message, the log, memory and assertions, which use the functions of scree_hooks.
#ifndef ERROR_H
#define ERROR_H
#include "platform/exact_floats.h"
#include "scree/scree.h"

#if defined(__GNUC__)
#define FORMAT(a, b) __attribute__((format(printf, a, b)))
#else
#define FORMAT(a, b)
#endif

// Sets the message that scree_error returns on this thread. Returns `status`.
scree_status fail(scree_status status, const char* format, ...) FORMAT(2, 3);

// Copies of the message of this thread, for calls that clean up after an error and must not replace it.
typedef struct
{
	char text[1024];
} Sentence;
Sentence sentence_keep(void);
void sentence_restore(const Sentence* kept);

#define TRY(expression)                         \
	do                                          \
	{                                           \
		scree_status try_status = (expression); \
		if (try_status != SCREE_OK)             \
			return try_status;                  \
	} while (0)

void log_sentence(scree_log_level level, const char* format, ...) FORMAT(2, 3);

// Allocates zeroed memory, aligned to 64 bytes, with the allocator hook, or returns null. bytes may be 0.
void* scree_allocate(size_t bytes);
// Resizes memory: keeps the first bytes, up to old_bytes; new bytes are zero. On failure returns null and changes
// nothing.
void* scree_reallocate(void* memory, size_t old_bytes, size_t bytes);
void scree_release(void* memory); // memory may be null

// Does the work of scree_hooks_set.
scree_status hooks_set(const scree_hooks* new_hooks);

void assert_failed(const char* expression, const char* file, int line);
#define ASSERT(x) ((x) ? (void)0 : assert_failed(#x, __FILE__, __LINE__))

// Adds `change` to the number of worlds; hooks cannot change while a world exists.
void worlds_add(int change);

#endif
