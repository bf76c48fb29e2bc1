// SPDX-License-Identifier: MIT
// cache.c -- stores compiled programs and verdicts on disk: one file per key, written under a temporary name and then
// renamed.
#include "opencl/cache.h"
#include "platform/error.h"
#include <errno.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#ifdef _WIN32
#include <direct.h>
#include <process.h>
#define make_folder(path) _mkdir(path)
#define process_number()  _getpid()
#define HOME              "LOCALAPPDATA"
#define BELOW_HOME        "/scree"
#define SEPARATORS        "/\\"
#else
#include <sys/stat.h>
#include <unistd.h>
#define make_folder(path) mkdir(path, 0700)
#define process_number()  (int)getpid()
#define HOME              "HOME"
#define BELOW_HOME        "/.cache/scree"
#define SEPARATORS        "/"
#endif

#define FOLDER_BYTES 4000                // path of the folder; Linux takes paths of 4,095 characters
#define PATH_BYTES   (FOLDER_BYTES + 40) // with the name of a file
#define MAX_BYTES    ((uint64_t)1 << 28) // a file that states a larger size is damaged

typedef struct // header of a file; content is the digest of the program that follows
{
	char magic[8];
	Digest key, content;
	uint64_t count;
} Header;
static const char magic[8] = "scree-1";

Digest digest_begin(void) { return (Digest){0xcbf29ce484222325u, 0x9e3779b97f4a7c15u}; }

// Adds bytes to both halves of a digest: `a` is FNV-1a (Fowler, Noll, Vo, 1991); `b` has another factor and a rotation.
void digest_add(Digest* digest, const void* bytes, size_t count)
{
	const unsigned char* byte = bytes;
	for (size_t i = 0; i < count; ++i)
	{
		digest->a = (digest->a ^ byte[i]) * 0x100000001b3u;
		digest->b = (digest->b ^ byte[i]) * 0xff51afd7ed558ccdu;
		digest->b = digest->b << 23 | digest->b >> 41;
	}
}

// Writes the path of the cache's folder. Returns false if no folder is set, or if the path is too long.
static bool cache_folder(char path[FOLDER_BYTES])
{
	const char* own = getenv("SCREE_CACHE");
	const char* shared = getenv("XDG_CACHE_HOME");
	const char* home = getenv(HOME);
	int length = 0;
	if (own)
		length = snprintf(path, FOLDER_BYTES, "%s", own);
	else if (shared && *shared)
		length = snprintf(path, FOLDER_BYTES, "%s/scree", shared);
	else if (home && *home)
		length = snprintf(path, FOLDER_BYTES, "%s" BELOW_HOME, home);
	if (length >= FOLDER_BYTES)
		log_sentence(SCREE_LOG_INFO, "The path of the cache has %d characters, more than %d; it is not used.", length,
		             FOLDER_BYTES - 1);
	return length > 0 && length < FOLDER_BYTES;
}

static void file_path(char* path, const char* folder, Digest key)
{
	snprintf(path, PATH_BYTES, "%s/%016llx%016llx.bin", folder, (unsigned long long)key.a, (unsigned long long)key.b);
}

static void make_folders(char* path)
{
	for (char* slash = strpbrk(path + 1, SEPARATORS); slash; slash = strpbrk(slash + 1, SEPARATORS))
	{
		char separator = *slash;
		*slash = '\0';
		make_folder(path);
		*slash = separator;
	}
	make_folder(path);
}

static bool equal(Digest x, Digest y) { return x.a == y.a && x.b == y.b; }

static Digest digest_of(const unsigned char* bytes, size_t count)
{
	Digest digest = digest_begin();
	digest_add(&digest, bytes, count);
	return digest;
}

unsigned char* cache_read(Digest key, size_t* count)
{
	char folder[FOLDER_BYTES], path[PATH_BYTES];
	if (!cache_folder(folder))
		return NULL;
	file_path(path, folder, key);
	FILE* file = fopen(path, "rb");
	if (!file)
		return NULL;

	Header header;
	unsigned char* bytes = NULL;
	bool good = fread(&header, sizeof header, 1, file) == 1 && memcmp(header.magic, magic, sizeof magic) == 0 &&
	            equal(header.key, key) && header.count > 0 && header.count < MAX_BYTES;
	if (good)
		bytes = scree_allocate((size_t)header.count);
	good = good && bytes && fread(bytes, 1, (size_t)header.count, file) == header.count && fgetc(file) == EOF &&
	       equal(digest_of(bytes, (size_t)header.count), header.content);
	fclose(file);
	if (!good)
	{
		scree_release(bytes);
		log_sentence(SCREE_LOG_INFO, "%s is damaged and will be written again.", path);
		return NULL;
	}
	*count = (size_t)header.count;
	return bytes;
}

void cache_write(Digest key, const unsigned char* bytes, size_t count)
{
	static atomic_int writers; // number of writes so far; it makes the names of temporary files unique
	char folder[FOLDER_BYTES], path[PATH_BYTES], temporary[PATH_BYTES + 32];
	if (!cache_folder(folder))
		return;
	make_folders(folder);
	file_path(path, folder, key);
	snprintf(temporary, sizeof temporary, "%s.%d.%d", path, process_number(), atomic_fetch_add(&writers, 1));

	Header header = {.key = key, .content = digest_of(bytes, count), .count = count};
	memcpy(header.magic, magic, sizeof magic);
	FILE* file = fopen(temporary, "wb");
	bool good = file && fwrite(&header, sizeof header, 1, file) == 1 && fwrite(bytes, 1, count, file) == count;
	if (file)
		good = fclose(file) == 0 && good;
#ifdef _WIN32
	if (good)
		remove(path); // on Windows rename does not replace an existing file
#endif
	good = good && rename(temporary, path) == 0;
	if (!good)
	{
		log_sentence(SCREE_LOG_INFO, "The cache could not be written (%s): %s", strerror(errno), path);
		remove(temporary);
	}
}
