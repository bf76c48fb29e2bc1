// SPDX-License-Identifier: MIT
// own_chains.c -- keeps the chains of worlds of a block whose masses or disabled joints differ from those of the template.
#include "batch/own_chains.h"
#include "platform/error.h"
#include "world/chain/chains.h"
#include "world/memory.h"
#include <string.h>

static void close_chains(OwnChains* chains)
{
	scree_release(chains->memory);
	scree_release(chains);
}

void own_chains_close(ChainList* list)
{
	for (int k = 0; k < list->count; ++k)
		close_chains(list->known[k]);
	scree_release((void*)list->known);
	*list = (ChainList){0};
}

static bool same_rows(const ChainRow* a, const ChainRow* b, int count)
{
	for (int k = 0; k < count; ++k)
		if (a[k].first != b[k].first || a[k].count != b[k].count || a[k].carried != b[k].carried)
			return false;
	return true;
}

static bool equal(const ChainSearch* a, const ChainSearch* b)
{
	const ChainLayout *x = &a->layout, *y = &b->layout;
	size_t nodes = (size_t)x->node_count;
	return a->joints == b->joints && x->count == y->count && x->branch_count == y->branch_count &&
	       x->node_count == y->node_count && same_rows(x->rows, y->rows, x->count) &&
	       same_rows(x->branches, y->branches, x->branch_count) &&
	       memcmp(x->joints, y->joints, sizeof(int) * (size_t)a->joints) == 0 &&
	       memcmp(x->node_joints, y->node_joints, sizeof(int) * nodes) == 0 &&
	       memcmp(x->nodes, y->nodes, sizeof(BranchNode) * nodes) == 0;
}

static OwnChains* known(const ChainList* list, const ChainSearch* search)
{
	for (int k = 0; k < list->count; ++k)
		if (equal(&list->known[k]->search, search))
			return list->known[k];
	return NULL;
}

static scree_status add(ChainList* list, const ChainSearch* search, char* memory, OwnChains** made)
{
	if (list->count == list->capacity)
	{
		size_t old = (size_t)list->capacity, now = 2 * old + 4;
		OwnChains** more = (OwnChains**)scree_reallocate((void*)list->known, old * sizeof *more, now * sizeof *more);
		if (!more)
			return fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory for the chains of a batch");
		list->known = more;
		list->capacity = (int)now;
	}
	*made = scree_allocate(sizeof **made);
	if (!*made)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory for the chains of a batch");
	**made = (OwnChains){.search = *search, .memory = memory};
	list->known[list->count++] = *made;
	return SCREE_OK;
}

scree_status own_chains_find(ChainList* list, const scree_world* world, const ChainSearch* template, OwnChains** found)
{
	ChainSearch search;
	char* memory;
	*found = NULL;
	TRY(chains_find(world, &search, &memory));
	bool same = equal(&search, template);
	scree_status status = SCREE_OK;
	OwnChains* before = same ? NULL : known(list, &search);
	*found = before;
	if (!same && !before)
		status = add(list, &search, memory, found);
	if (same || before || status != SCREE_OK)
		scree_release(memory);
	if (*found && status == SCREE_OK)
		++(*found)->uses;
	return status;
}

void own_chains_leave(ChainList* list, OwnChains* chains)
{
	if (!chains || --chains->uses > 0)
		return;
	for (int k = 0; k < list->count; ++k)
		if (list->known[k] == chains)
			list->known[k] = list->known[--list->count];
	close_chains(chains);
}

void own_chains_mark(const ChainSearch* search, uint8_t* joints, uint8_t bit)
{
	const ChainLayout* layout = &search->layout;
	for (int k = 0; k < layout->count; ++k)
		for (int n = 0; n < layout->rows[k].count; ++n)
			joints[layout->joints[layout->rows[k].first + n]] |= bit;
	for (int k = 0; k < layout->node_count; ++k)
		if (layout->node_joints[k] >= 0)
			joints[layout->node_joints[k]] |= bit;
}
