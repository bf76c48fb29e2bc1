// SPDX-License-Identifier: MIT
// work_items.c -- runs fibers in turns, with barriers and with delayed writes to mailboxes.
#include "emulation/work_items.h"
#include "tools/common/random_numbers.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <ucontext.h>

#if defined(__SANITIZE_ADDRESS__)
#define ASAN
#endif
#if defined(__SANITIZE_THREAD__)
#define TSAN
#endif
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define ASAN
#endif
#if __has_feature(thread_sanitizer)
#define TSAN
#endif
#endif
#ifdef ASAN
#include <sanitizer/common_interface_defs.h>
#define STACK_BYTES ((size_t)256 << 10)
#else
#define STACK_BYTES ((size_t)64 << 10)
#endif

#define MOST_GROUPS   512
#define MOST_SWITCHES ((int64_t)1 << 24) // maximum number of switches per launch, some seconds; launches need far fewer
#define MOST_LATE     12                 // maximum number of pieces that have been written and have not arrived

typedef struct
{
	ucontext_t context;
	char* stack;
	void* shadow; // fake stack of the address sanitizer
	int group, lane;
	int at; // position in Group.ready; -1 after the work-item has ended
	int looks;
} Item;

typedef struct
{
	Item** ready; // work-items that can continue
	int ready_count, ended;
	int met; // number of work-items that have reached the barrier at this file and line:
	const char* file;
	int line;
	unsigned char* memory; // __local memory of the group, while another group has the turn
} Group;

typedef struct // part of two words that has been written and has not arrived
{
	volatile unsigned char* place;
	unsigned char bytes[16];
} Piece;

// __local memory of the group that has the turn, for all kernels
extern unsigned char __start_group_memory[], __stop_group_memory[];

static ucontext_t home;
#ifdef ASAN
static void* home_shadow;
static const void* home_bottom;
static size_t home_bytes;
#endif
static Item** items; // as many work-items as the largest launch had
static int item_count;
static Group groups[MOST_GROUPS];
static Launch launch;
static Schedule schedule;
static Item* now; // work-item that has the turn
static uint64_t state;
static unsigned patience; // on average, one of `patience` possible switches ends the turn of a work-item
static int64_t switches_left, put_count;
static Piece pieces[MOST_LATE];
static int piece_count;
static const char* trouble;

static unsigned next_random(void) { return (unsigned)(random_word(&state) >> 32); }

static int random_of(int count) { return (int)(((uint64_t)next_random() * (uint64_t)count) >> 32); }

// ---------------------------------------------------------------------------------------------------------------
// turns
// ---------------------------------------------------------------------------------------------------------------

static size_t memory_bytes(void) { return (size_t)(__stop_group_memory - __start_group_memory); }

// Returns a group in which a work-item can continue; -1 if there is none. Mostly returns the group `last`, because no
// memory is copied if the group stays the same.
static int choose_group(int last)
{
	if (last + 1 != schedule.shunned && groups[last].ready_count > 0 && next_random() % 16 != 0)
		return last;
	int found[MOST_GROUPS], count = 0;
	for (int g = 0; g < launch.groups; ++g)
		if (groups[g].ready_count > 0 && g + 1 != schedule.shunned)
			found[count++] = g;
	if (count > 0)
		return found[random_of(count)];
	return schedule.shunned > 0 && groups[schedule.shunned - 1].ready_count > 0 ? schedule.shunned - 1 : -1;
}

// Switches from the current fiber to the fiber of `to`, or to `home` if `to` is null. If `ends` is true, the current
// fiber never continues.
static void go(Item* to, bool ends)
{
	Item* from = now;
	if (to == from)
		return;
	if (to && (!from || to->group != from->group))
	{
		if (from)
			memcpy(groups[from->group].memory, __start_group_memory, memory_bytes());
		memcpy(__start_group_memory, groups[to->group].memory, memory_bytes());
	}
	now = to;
#ifdef ASAN
	void** shadow = from ? &from->shadow : &home_shadow;
	__sanitizer_start_switch_fiber(ends ? NULL : shadow, to ? to->stack : home_bottom, to ? STACK_BYTES : home_bytes);
#endif
	if (ends && to)
		setcontext(&to->context);
	swapcontext(from ? &from->context : &home, to ? &to->context : &home);
#ifdef ASAN
	__sanitizer_finish_switch_fiber(from ? from->shadow : home_shadow, NULL, NULL);
#endif
}

static void go_on(bool ends)
{
	int last = now ? now->group : 0, g = --switches_left < 0 ? -1 : choose_group(last);
	if (switches_left < 0)
		trouble = "they come to no end";
	Item* next = g < 0 ? NULL : groups[g].ready[random_of(groups[g].ready_count)];
	go(next, ends);
}

static void become_ready(Item* item)
{
	Group* g = groups + item->group;
	item->at = g->ready_count;
	g->ready[g->ready_count++] = item;
}

static void wait_for_others(Item* item)
{
	Group* g = groups + item->group;
	g->ready[item->at] = g->ready[--g->ready_count];
	g->ready[item->at]->at = item->at;
}

// Lets the work-items of a group continue when all of them have reached the barrier.
static void release(int group)
{
	Group* g = groups + group;
	if (g->met == 0 || g->met + (schedule.leavers ? g->ended : 0) < launch.group)
		return;
	g->ready_count = 0;
	g->met = 0;
	for (int lane = 0; lane < launch.group; ++lane)
		if (items[group * launch.group + lane]->at >= 0)
			become_ready(items[group * launch.group + lane]);
}

static void item_main(void)
{
#ifdef ASAN
	__sanitizer_finish_switch_fiber(NULL, home_bottom ? NULL : &home_bottom, home_bytes ? NULL : &home_bytes);
#endif
	launch.item(launch.arguments);
	Group* g = groups + now->group;
	wait_for_others(now);
	now->at = -1;
	++g->ended;
	release(now->group);
	go_on(true);
}

void items_yield(void)
{
	if (next_random() % patience == 0)
		go_on(false);
}

void items_meet(const char* file, int line)
{
	Group* g = groups + now->group;
	if (g->met > 0 && (g->line != line || strcmp(g->file, file) != 0))
	{
		trouble = "those of a group meet at different barriers";
		go(NULL, true);
	}
	g->file = file;
	g->line = line;
	++g->met;
	wait_for_others(now);
	release(now->group);
	go_on(false);
}

int items_group(void) { return now->group; }
int items_groups(void) { return launch.groups; }
int items_lane(void) { return now->lane; }
int items_group_size(void) { return launch.group; }

// ---------------------------------------------------------------------------------------------------------------
// words
// ---------------------------------------------------------------------------------------------------------------

// Stores the oldest piece with the same place as piece k, and removes it from the list of pieces.
static void piece_arrives(int k)
{
	for (int older = 0; older < k; ++older)
		if (pieces[older].place == pieces[k].place)
			k = older;
	memcpy((void*)(uintptr_t)pieces[k].place, pieces[k].bytes, (size_t)schedule.pieces);
	--piece_count;
	memmove(pieces + k, pieces + k + 1, (size_t)(piece_count - k) * sizeof *pieces);
}

static void all_arrive(void)
{
	while (piece_count > 0)
		piece_arrives(0);
}

WordPair items_look(const volatile void* place)
{
	++now->looks;
	items_yield();
	if (piece_count > 0 && next_random() % 2)
		piece_arrives(random_of(piece_count));
	WordPair words;
	memcpy(&words, (const void*)(uintptr_t)place, sizeof words);
	return words;
}

void items_put(volatile void* place, WordPair words)
{
	items_yield();
	if (++put_count == schedule.lost)
		return;
	for (int at = 0; at < 16; at += schedule.pieces)
	{
		if (piece_count == MOST_LATE)
			piece_arrives(random_of(piece_count));
		Piece* piece = pieces + piece_count++;
		piece->place = (volatile unsigned char*)place + at;
		memcpy(piece->bytes, (const unsigned char*)&words + at, (size_t)schedule.pieces);
	}
	if (!schedule.late)
		all_arrive();
}

// ---------------------------------------------------------------------------------------------------------------
// launches
// ---------------------------------------------------------------------------------------------------------------

static void item_prepare(Item* item, int group, int lane)
{
	item->group = group;
	item->lane = lane;
	item->looks = 0;
	getcontext(&item->context);
	item->context.uc_stack.ss_sp = item->stack;
	item->context.uc_stack.ss_size = STACK_BYTES;
	item->context.uc_link = NULL;
	makecontext(&item->context, item_main, 0);
	become_ready(item);
}

static void prepare(void)
{
	int count = launch.groups * launch.group;
	if (count > item_count)
	{
		items = realloc(items, (size_t)count * sizeof *items);
		for (; item_count < count; ++item_count)
		{
			items[item_count] = calloc(1, sizeof(Item));
			items[item_count]->stack = malloc(STACK_BYTES);
		}
	}
	for (int g = 0; g < launch.groups; ++g)
	{
		size_t bytes = memory_bytes();
		groups[g] = (Group){.ready = malloc((size_t)launch.group * sizeof(Item*)), .memory = malloc(bytes)};
		memset(groups[g].memory, 0xa5, bytes);
		for (int lane = 0; lane < launch.group; ++lane)
			item_prepare(items[g * launch.group + lane], g, lane);
	}
}

bool items_run(const Launch* what, const Schedule* how, char sentence[ITEMS_SENTENCE])
{
	if (what->groups > MOST_GROUPS)
	{
		snprintf(sentence, ITEMS_SENTENCE, "%d groups are more than %d", what->groups, MOST_GROUPS);
		return false;
	}
	launch = *what;
	schedule = *how;
	schedule.pieces = schedule.pieces ? schedule.pieces : (int)sizeof(WordPair);
	state = how->seed;
	patience = 1u << next_random() % 4;
	switches_left = MOST_SWITCHES;
	put_count = 0;
	trouble = NULL;
	prepare();
	now = NULL;
	go_on(false);

	all_arrive();
	int ended = 0, group = 0;
	for (int g = 0; g < launch.groups; ++g)
	{
		ended += groups[g].ended;
		group = groups[g].met > 0 ? g : group;
		free(groups[g].ready);
		free(groups[g].memory);
	}
	if (ended == launch.groups * launch.group)
		return true;
	const Group* g = groups + group;
	snprintf(sentence, ITEMS_SENTENCE, "%d of %d work-items ended: %s; %d of group %d are at the barrier of %s:%d",
	         ended, launch.groups * launch.group, trouble ? trouble : "the others wait for each other", g->met, group,
	         g->file ? g->file : "nowhere", g->line);
	return false;
}

int items_looks(int group)
{
	int most = 0;
	for (int i = group * launch.group; i < (group + 1) * launch.group; ++i)
		most = items[i]->looks > most ? items[i]->looks : most;
	return most;
}

int items_puts(void) { return (int)put_count; }

void items_close(void)
{
	for (int i = 0; i < item_count; ++i)
	{
		free(items[i]->stack);
		free(items[i]);
	}
	free(items);
	items = NULL;
	item_count = 0;
}

const char* items_refused(void)
{
#ifdef TSAN
	return "the thread sanitizer cannot follow the fibers";
#else
	return NULL;
#endif
}
