// SPDX-License-Identifier: MIT
// error.c -- implements the last error message, the log, memory and assertions, through the hooks of the process.
#define _GNU_SOURCE // declares madvise; ignored on other systems
#include "platform/error.h"
#include "platform/processor.h"
#include <stdarg.h>
#include <stdatomic.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#ifdef _WIN32
#include <malloc.h>
#endif
#ifdef __linux__
#include <sys/mman.h>
#endif

#define SENTENCE_BYTES sizeof(Sentence)
#define ALIGNMENT      64

// Minimum size of a block for which huge pages are requested, bytes. Reads of bodies at random places of a large pool
// miss the TLB. With huge pages and a million bodies, passes of the solver took 5 to 13 % less time.
#define HUGE_BLOCK ((size_t)4 << 20)
#define HUGE_PAGE  ((size_t)2 << 20)

// Minimum size of a block, below HUGE_BLOCK, that is requested as zeroed memory, bytes. The system maps such a block, and
// pages that nobody writes take no memory and no time: the creation of many worlds on a CPU writes half of its pools.
#define ZERO_BLOCK ((size_t)4 << 10)

// Minimum size of a block that grows, below HUGE_BLOCK, that is mapped by itself, bytes. The C library may take such a block from
// memory that was released, and then writes all of it.
#define MAPPED_BLOCK ((size_t)64 << 10)

static _Thread_local char sentence[SENTENCE_BYTES];
static atomic_size_t memory_in_use;
static atomic_int worlds;

static void* default_allocate(size_t bytes, size_t alignment, void* context)
{
	(void)context;
#ifdef _WIN32
	return _aligned_malloc(bytes, alignment);
#else
#ifdef __linux__
	if (bytes >= HUGE_BLOCK && alignment <= HUGE_PAGE)
	{
		size_t pages = (bytes + HUGE_PAGE - 1) / HUGE_PAGE * HUGE_PAGE;
		void* memory = aligned_alloc(HUGE_PAGE, pages);
		if (memory)
			madvise(memory, pages, MADV_HUGEPAGE);
		return memory;
	}
#endif
	return aligned_alloc(alignment, bytes);
#endif
}

// Returns zeroed memory of the default allocator, aligned, and the block that contains it; null for sizes that are not
// requested in this way, or if there is no memory.
static void* zeroed(size_t bytes, void** block)
{
#if defined(_WIN32) || defined(SCREE_SMALL) // WebAssembly maps no zeroed memory
	(void)bytes, (void)block;
	return NULL;
#else
	if (bytes < ZERO_BLOCK || bytes >= HUGE_BLOCK)
		return NULL;
	char* memory = *block = calloc(1, bytes + ALIGNMENT);
	return memory ? memory + (ALIGNMENT - (uintptr_t)memory % ALIGNMENT) % ALIGNMENT : NULL;
#endif
}

// Releases memory of the function above. context: the block.
static void release_block(void* memory, void* context)
{
	(void)memory;
	free(context);
}

// Returns memory that the system maps: zeroed, and without pages until they are written. Null for sizes that are not mapped, or if
// there is no memory. A sanitizer sees no end of such blocks.
static void* mapped(size_t bytes)
{
#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__)
	if (bytes >= MAPPED_BLOCK && bytes < HUGE_BLOCK)
	{
		void* memory = mmap(NULL, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
		return memory == MAP_FAILED ? NULL : memory;
	}
#endif
	(void)bytes;
	return NULL;
}

// Releases such memory. context: one past its end.
static void release_mapped(void* memory, void* context)
{
#ifdef __linux__
	munmap(memory, (size_t)((char*)context - (char*)memory));
#endif
	(void)memory, (void)context;
}

static void default_release(void* memory, void* context)
{
	(void)context;
#ifdef _WIN32
	_aligned_free(memory);
#else
	free(memory);
#endif
}

static void default_log(scree_log_level level, const char* text, void* context)
{
	(void)context;
	if (level == SCREE_LOG_WARNING)
		fprintf(stderr, "scree: warning: %s\n", text);
}

static void default_assert_failed(const char* expression, const char* file, int line, void* context)
{
	(void)context;
	fprintf(stderr, "scree: %s:%d: assertion failed: %s\n", file, line, expression);
	abort();
}

static scree_hooks hooks = {default_allocate, default_release, default_log, default_assert_failed, NULL};

const char* scree_error(void) { return sentence; }

const char* scree_status_name(scree_status status)
{
	switch (status)
	{
	case SCREE_OK:
		return "ok";
	case SCREE_ERROR_INVALID:
		return "invalid";
	case SCREE_ERROR_STALE:
		return "stale";
	case SCREE_ERROR_OUT_OF_MEMORY:
		return "out of memory";
	case SCREE_ERROR_NO_DEVICE:
		return "no device";
	case SCREE_ERROR_DEVICE_FAILED:
		return "device failed";
	case SCREE_ERROR_NOT_SUPPORTED:
		return "not supported";
	case SCREE_ERROR_CONTACT_LIMIT:
		return "contact limit";
	case SCREE_ERROR_FILE:
		return "file";
	case SCREE_ERROR_DIFFERENT:
		return "different";
	}
	return "unknown";
}

#define TEXT_(x) #x
#define TEXT(x)  TEXT_(x)
const char* scree_version(void)
{
	return TEXT(SCREE_VERSION_MAJOR) "." TEXT(SCREE_VERSION_MINOR) "." TEXT(SCREE_VERSION_PATCH);
}

scree_status fail(scree_status status, const char* format, ...)
{
	// text is formatted in a second buffer, because an argument may be the current message
	char text[SENTENCE_BYTES];
	va_list arguments;
	va_start(arguments, format);
	vsnprintf(text, sizeof(text), format, arguments);
	va_end(arguments);
	memcpy(sentence, text, sizeof(sentence));
	return status;
}

Sentence sentence_keep(void)
{
	Sentence kept;
	memcpy(kept.text, sentence, sizeof kept.text);
	return kept;
}

void sentence_restore(const Sentence* kept) { memcpy(sentence, kept->text, sizeof kept->text); }

void log_sentence(scree_log_level level, const char* format, ...)
{
	FLOAT_MODE_HERE; // a hook may change the mode
	char text[SENTENCE_BYTES];
	va_list arguments;
	va_start(arguments, format);
	vsnprintf(text, sizeof(text), format, arguments);
	va_end(arguments);
	hooks.log(level, text, hooks.context);
}

scree_status hooks_set(const scree_hooks* new_hooks)
{
	if (atomic_load(&worlds) > 0)
		return fail(SCREE_ERROR_INVALID, "scree_hooks_set: hooks cannot change while %d world(s) exist",
		            atomic_load(&worlds));
	if (new_hooks && !new_hooks->allocate != !new_hooks->release)
		return fail(SCREE_ERROR_INVALID,
		            "scree_hooks_set: hooks.allocate is %s but hooks.release is %s: give both or none",
		            new_hooks->allocate ? "set" : "null", new_hooks->release ? "set" : "null");
	scree_hooks given = new_hooks ? *new_hooks : (scree_hooks){0};
	hooks.allocate = given.allocate ? given.allocate : default_allocate;
	hooks.release = given.release ? given.release : default_release;
	hooks.log = given.log ? given.log : default_log;
	hooks.assert_failed = given.assert_failed ? given.assert_failed : default_assert_failed;
	hooks.context = given.context;
	return SCREE_OK;
}

size_t scree_memory(void) { return atomic_load(&memory_in_use); }

// Header before every block. It stores the function that releases the block, because the hooks may change later.
typedef struct
{
	_Alignas(ALIGNMENT) size_t bytes; // size of the block, header included
	void (*release)(void* memory, void* context);
	void* context;
} Header;
_Static_assert(sizeof(Header) == ALIGNMENT, "what follows the header is aligned as well");

// grows: whether the block is one of those that scree_reallocate enlarges.
static void* allocate(size_t bytes, bool grows)
{
	FLOAT_MODE_HERE;
	if (bytes > SIZE_MAX - 2 * ALIGNMENT)
		return NULL;
	size_t all = (sizeof(Header) + bytes + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
	void* block = NULL;
	bool own = hooks.allocate == default_allocate;
	Header* map = own && grows ? mapped(all) : NULL;
	Header* header = map || !own ? map : zeroed(all, &block);
	if (!header)
	{
		header = hooks.allocate(all, ALIGNMENT, hooks.context);
		if (!header)
			return NULL;
		ASSERT((uintptr_t)header % ALIGNMENT == 0);
		memset(header, 0, all);
	}
	header->bytes = all;
	header->release = map ? release_mapped : block ? release_block : hooks.release;
	header->context = map ? (char*)map + all : block ? block : hooks.context;
	atomic_fetch_add(&memory_in_use, all);
	return header + 1;
}

void* scree_allocate(size_t bytes) { return allocate(bytes, false); }

void* scree_reallocate(void* memory, size_t old_bytes, size_t bytes)
{
	void* larger = allocate(bytes, true);
	if (larger && memory)
	{
		memcpy(larger, memory, old_bytes < bytes ? old_bytes : bytes);
		scree_release(memory);
	}
	return larger;
}

void scree_release(void* memory)
{
	if (!memory)
		return;
	FLOAT_MODE_HERE;
	Header* header = (Header*)memory - 1;
	atomic_fetch_sub(&memory_in_use, header->bytes);
	header->release(header, header->context);
}

void assert_failed(const char* expression, const char* file, int line)
{
	hooks.assert_failed(expression, file, line, hooks.context);
}

void worlds_add(int change) { atomic_fetch_add(&worlds, change); }
