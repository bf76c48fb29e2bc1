// SPDX-License-Identifier: MIT
// page_moment.c -- writes and restores moments of the page: snapshots with parts for what the page has beside the world.
//
// page.tools: words of PageTools. page.source: a text, only in files: scene, parameters and actions. The scene player adds its own
// parts (scene/player_file.c).
#include "scene/player_file.h"
#include "web/page.h"
#include <stdlib.h>
#include <string.h>

typedef struct // words of four bytes; later versions of the page may append members, which are 0 in older files
{
	int launched, poured, kind_count;
	uint32_t pouring, due;
	float pour_size, thrown_size, thrown_density;
	scree_attribute thrown[3], kinds[POUR_KINDS];
	scree_joint joint;
	scree_body body;
	scree_vec anchor, at;
} PageTools;

static PageTools read_tools(void)
{
	const Grab* g = &page.grab;
	const Pour* p = &page.pour;
	PageTools t = {.launched = g->launched,
	               .poured = p->poured,
	               .kind_count = p->kind_count,
	               .pouring = p->on,
	               .due = p->due,
	               .pour_size = p->size,
	               .thrown_size = g->thrown_size,
	               .thrown_density = g->thrown_density,
	               .joint = g->joint,
	               .body = g->body,
	               .anchor = g->anchor,
	               .at = g->at};
	memcpy(t.thrown, g->thrown, sizeof t.thrown);
	memcpy(t.kinds, p->kinds, sizeof t.kinds);
	return t;
}

// Sets the tools. A file may be hostile, so numbers that are indices are bounded; handles are checked by each call.
static void set_tools(const PageTools* t)
{
	Grab* g = &page.grab;
	Pour* p = &page.pour;
	page_begin_tools();
	g->launched = t->launched & INT32_MAX;
	g->thrown_size = t->thrown_size;
	g->thrown_density = t->thrown_density;
	memcpy(g->thrown, t->thrown, sizeof t->thrown);
	g->joint = t->joint;
	g->body = t->body;
	g->anchor = t->anchor;
	g->at = t->at;
	p->poured = t->poured & (INT32_MAX >> 1);
	p->kind_count = t->kind_count < 0 || t->kind_count > POUR_KINDS ? 0 : t->kind_count;
	p->on = t->pouring && p->kind_count > 0;
	p->due = t->due && p->kind_count > 0;
	p->size = t->pour_size;
	memcpy(p->kinds, t->kinds, sizeof t->kinds);
}

// Returns the address and the size of a moment, which are valid until the next one; null on failure. source: text for a file;
// empty: none.
EMSCRIPTEN_KEEPALIVE const double* page_moment(const char* source)
{
	const PageTools tools = read_tools();
	const void* bytes;
	size_t size;
	const FilePart parts[] = {
	    {"page.tools", 4, &tools, sizeof tools},
	    {"page.source", 1, source, strlen(source)},
	};
	if (!page_check(player_save(&page.player, parts, sizeof parts / sizeof *parts, &bytes, &size)))
		return NULL;
	page.numbers[0] = (double)(uintptr_t)bytes;
	page.numbers[1] = (double)size;
	return page.numbers;
}

// Returns the text page.source of a file, which the caller frees: empty if the file has none; null if it is damaged.
EMSCRIPTEN_KEEPALIVE char* page_moment_source(const void* bytes, size_t size)
{
	FilePart source = {.name = "page.source", .unit = 1};
	if (!page_check(moment_read(bytes, size, &source, 1)))
		return NULL;
	char* text = calloc(source.bytes + 1, 1);
	if (text && source.bytes > 0)
		memcpy(text, source.values, source.bytes);
	if (!text)
		page_fail("there is no memory to read this file");
	return text;
}

// Restores a moment of the current scene. On failure returns false; the world may then have changed, so the page loads the
// scene again. A file of another program lacks the tools.
EMSCRIPTEN_KEEPALIVE bool page_return(const void* bytes, size_t size)
{
	PageTools tools = {0};
	FilePart words = {.name = "page.tools", .unit = 4};
	if (!page_check(player_load(&page.player, bytes, size, &words, 1)))
		return false;
	if (words.bytes > 0)
		memcpy(&tools, words.values, words.bytes < sizeof tools ? words.bytes : sizeof tools);
	set_tools(&tools);
	page.renderer.flashes.count = 0;
	return page_show_world();
}
