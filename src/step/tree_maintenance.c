// SPDX-License-Identifier: MIT
// tree_maintenance.c -- maintains the trees of the broad phase on the host: lists leaves, and decides when to sort.
#include "step/tree_maintenance.h"
#include "platform/error.h"
#include <string.h>

// The device measures all boxes, and decides whether boxes jump so far that the leaves must be sorted. After it has
// decided to sort, the next steps sort the leaves without a measurement; one step in CHURN_STEPS measures again.
#define CHURN_STEPS 4

// Room of a tree for leaves that are appended, as a share and as a least number of leaves, in a world that sleeps.
#define SPARE_SHARE 64
#define SPARE_LEAST 64

#define LEFT_SOON 24 // distance, in collidables, between the prefetch of an entry of Pipeline.member and its use

// Bits of Pipeline.member. HAS_LEAF: a leaf of tree t refers to the collidable. BELONGS: it is alive and in tree t.
#define HAS_LEAF(t) (1 << (t))
#define BELONGS(t)  (4 << (t))

// Lets the next step and the next query compute all boxes of a tree.
static void move(TreeState* state)
{
	state->change = TREE_MOVED;
	state->seen = false;
	state->boxed = 0;
}

// Lets the next step and the next query compute the boxes that an edit of the user may change. All collidables that the
// user has changed are in active groups, if the device lists groups (world/device/touched.c).
static void edit(Pipeline* pipeline, int t)
{
	TreeState* state = &pipeline->trees[t];
	if (t != 0 || !pipeline->listed)
		move(state);
	else if (state->change == TREE_KEPT)
		state->change = TREE_EDITED;
	state->seen = false;
}

int tree_padded(int count) { return (count + ARITY - 1) / ARITY * ARITY; }

int tree_nodes(int leaves)
{
	int nodes = tree_padded(leaves);
	while (leaves > ARITY)
	{
		leaves = (leaves + ARITY - 1) / ARITY;
		nodes += tree_padded(leaves);
	}
	return nodes + ARITY; // + ARITY for the root, behind the highest level
}

// Computes the number of leaves for which the levels of a tree have room. In a world that sleeps, appended leaves must
// not move the levels above them, since then all boxes of nodes are computed.
static int room_of(const Pipeline* pipeline, const TreeState* state)
{
	int leaves = state->tree.leaves,
	    spare = pipeline->listed && !OF_BATCH(pipeline) ? leaves / SPARE_SHARE + SPARE_LEAST : 0;
	int capacity = pipeline->backend->capacity[PER_COLLIDABLE];
	if (leaves == 0 || (leaves <= state->room && state->room <= leaves + 2 * spare && state->room <= capacity))
		return leaves == 0 ? 0 : state->room;
	return leaves + spare < capacity ? leaves + spare : capacity;
}

// Computes the position of a tree in the pools, and its levels. Uploads the tree if it changed.
static scree_status tree_layout(Pipeline* pipeline, int t)
{
	Backend* b = pipeline->backend;
	TreeState* state = &pipeline->trees[t];
	Tree* tree = &state->tree;
	int capacity = pipeline->backend->capacity[PER_COLLIDABLE];
	tree->leaf_begin = t * capacity;
	int begin = t * tree_nodes(capacity), count = tree->leaves, room = room_of(pipeline, state);
	if (room != state->room)
		move(state); // the boxes of the new room are not empty
	state->room = room;
	for (tree->top = 0;; ++tree->top)
	{
		tree->begin[tree->top] = begin;
		tree->count[tree->top] = count;
		if (count <= ARITY)
			break;
		begin += tree_padded(room);
		count = (count + ARITY - 1) / ARITY;
		room = (room + ARITY - 1) / ARITY;
	}
	if (memcmp(tree, &state->sent, sizeof *tree) == 0)
		return SCREE_OK;
	if (tree->top != state->sent.top || memcmp(tree->begin, state->sent.begin, sizeof tree->begin) != 0)
		move(state);
	state->sent = *tree;
	return b->f->write(b, POOL_tree, t, 1, tree);
}

scree_status tree_reserve(Pipeline* pipeline, int collidables)
{
	if (collidables <= pipeline->member_capacity)
		return SCREE_OK;
	int capacity = collidables + collidables / 2 + 64;
	uint8_t* member = scree_reallocate(pipeline->member, (size_t)pipeline->member_capacity, (size_t)capacity);
	if (!member)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory for %d collidables", capacity);
	pipeline->member = member;
	pipeline->member_capacity = capacity;
	return SCREE_OK;
}

scree_status tree_insert(Pipeline* pipeline, int t, int collidable)
{
	TRY(tree_reserve(pipeline, collidable + 1));
	TreeState* state = &pipeline->trees[t];
	edit(pipeline, t);
	pipeline->statics |= t == 1;
	pipeline->member[collidable] |= BELONGS(t);
	if (pipeline->member[collidable] & HAS_LEAF(t))
		return SCREE_OK;
	if (state->added_count == state->added_capacity)
	{
		int capacity = 2 * state->added_capacity + 64;
		int* added =
		    scree_reallocate(state->added, sizeof(int) * (size_t)state->added_capacity, sizeof(int) * (size_t)capacity);
		if (!added)
		{
			pipeline->member[collidable] &= (uint8_t)~BELONGS(t);
			return fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory for %d new leaves", capacity);
		}
		state->added = added;
		state->added_capacity = capacity;
	}
	pipeline->member[collidable] |= HAS_LEAF(t);
	state->added[state->added_count++] = collidable;
	return SCREE_OK;
}

void tree_withdraw(Pipeline* pipeline, int collidable)
{
	// the insertion may have failed before the array `member` had room for the collidable
	if (collidable >= pipeline->member_capacity)
		return;
	for (int t = 0; t < 2; ++t)
	{
		TreeState* state = &pipeline->trees[t];
		pipeline->member[collidable] &= (uint8_t)~BELONGS(t);
		if (state->added_count == 0 || state->added[state->added_count - 1] != collidable)
			continue;
		--state->added_count;
		pipeline->member[collidable] &= (uint8_t)~HAS_LEAF(t);
	}
}

void tree_touch(Pipeline* pipeline, int t) { move(&pipeline->trees[t]); }

void tree_forget(Pipeline* pipeline, int t) { pipeline->trees[t].seen = false; }

void tree_leave(Pipeline* pipeline, int t, int collidable)
{
	TreeState* state = &pipeline->trees[t];
	edit(pipeline, t);
	pipeline->member[collidable] &= (uint8_t)~BELONGS(t);
	if (state->left_count == state->left_capacity && !state->shrunk)
	{
		// beyond this capacity, a visit of all slots of `member` takes no longer than a visit of the list
		int capacity = 2 * state->left_capacity + 64;
		int* left = capacity <= pipeline->member_capacity
		                ? scree_reallocate(state->left, sizeof(int) * (size_t)state->left_capacity,
		                                   sizeof(int) * (size_t)capacity)
		                : NULL;
		state->left = left ? left : state->left;
		state->left_capacity = left ? capacity : state->left_capacity;
		state->shrunk = !left;
	}
	if (!state->shrunk)
		state->left[state->left_count++] = collidable;
}

scree_status tree_restore_leaves(Pipeline* pipeline, int t, const int* leaves, int count)
{
	Backend* b = pipeline->backend;
	pipeline->trees[t].tree.leaves = count;
	for (int k = 0; k < count; ++k)
		pipeline->member[leaves[k]] |= BELONGS(t) | HAS_LEAF(t);
	return count > 0 ? b->f->write(b, POOL_leaf, t * b->capacity[PER_COLLIDABLE], count, leaves) : SCREE_OK;
}

scree_status tree_upload(Pipeline* pipeline)
{
	Backend* b = pipeline->backend;
	for (int t = 0; t < 2; ++t)
	{
		TreeState* state = &pipeline->trees[t];
		if (state->added_count > 0)
		{
			int first = t * b->capacity[PER_COLLIDABLE] + state->tree.leaves;
			TRY(b->f->write(b, POOL_leaf, first, state->added_count, state->added));
			state->tree.leaves += state->added_count;
			state->unsorted += state->added_count;
			state->appended += state->added_count;
			state->added_count = 0;
			edit(pipeline, t);
		}
		TRY(tree_layout(pipeline, t));
	}
	return SCREE_OK;
}

// Returns whether the wasted node visits have reached the cost of sorting the leaves, about ORDER_VISITS per leaf, so
// the total cost stays within twice the minimum. A box changes when its collidable has moved by the margin, 1/8 of its
// own size. After c changes of each box, a traversal visits about 2 c more nodes than after the sort, in sum c^2 per
// leaf. Without jumps, the leaves are sorted after four changes of every box, when neighbors on the curve are still
// near each other. Sorting after eight changes made the broad phase 3 % faster in scenes that tumble, but would lose
// more if bodies fly.
bool tree_wants_order(const TreeState* state)
{
	double leaves = state->tree.leaves, changes = (double)state->unsorted / leaves;
	return state->tree.leaves > ARITY && changes * changes + state->outliers / leaves > ORDER_VISITS;
}

bool tree_churns(const TreeState* state) { return state->tree.leaves > ARITY && state->churned % CHURN_STEPS != 0; }

void tree_count(TreeState* state, const Counters* counters, int t)
{
	if (t == 0)
		state->unsorted += counters->updated_boxes;
	state->outliers += (double)counters->updated_boxes * counters->outliers[t] / OUTLIER_UNIT;
	state->churned = counters->order[t] || state->ordered ? state->churned + 1 : 0;
}

// Removes the leaf of collidable k from tree t, if it exists and the collidable no longer belongs to the tree.
static void drop(Pipeline* pipeline, int t, int k)
{
	if ((pipeline->member[k] & (HAS_LEAF(t) | BELONGS(t))) != HAS_LEAF(t))
		return;
	pipeline->member[k] &= (uint8_t)~HAS_LEAF(t);
	--pipeline->trees[t].tree.leaves;
}

scree_status tree_ordered(Pipeline* pipeline, int t)
{
	TreeState* state = &pipeline->trees[t];
	state->unsorted = 0;
	state->appended = 0;
	state->outliers = 0;
	state->seen = false;
	state->boxed = 0;
	if (!state->shrunk && state->left_count == 0)
		return SCREE_OK;
	for (int k = 0; k < pipeline->member_capacity && state->shrunk; ++k)
		drop(pipeline, t, k);
	for (int k = 0; k < state->left_count; ++k)
	{
		if (k + LEFT_SOON < state->left_count)
			fetch_soon(pipeline->member + state->left[k + LEFT_SOON]);
		drop(pipeline, t, state->left[k]);
	}
	state->left_count = 0;
	state->shrunk = false;
	if (state->placed > state->tree.leaves)
		state->placed = state->tree.leaves;
	return tree_layout(pipeline, t);
}

scree_status tree_save(Pipeline* pipeline, int** leaves)
{
	Backend* b = pipeline->backend;
	const TreeState* trees = pipeline->trees;
	*leaves = scree_allocate(sizeof(int) * (size_t)(trees[0].tree.leaves + trees[1].tree.leaves));
	if (!*leaves)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory to move %d leaves",
		            trees[0].tree.leaves + trees[1].tree.leaves);
	int* to = *leaves;
	for (int t = 0; t < 2; ++t)
	{
		int count = trees[t].tree.leaves;
		if (count > 0)
			TRY(b->f->read(b, POOL_leaf, t * b->capacity[PER_COLLIDABLE], count, to));
		to += count;
	}
	return SCREE_OK;
}

scree_status tree_restore(Pipeline* pipeline, int* leaves)
{
	Backend* b = pipeline->backend;
	const int* from = leaves;
	scree_status status = SCREE_OK;
	for (int t = 0; t < 2 && !status; ++t)
	{
		TreeState* state = &pipeline->trees[t];
		if (state->tree.leaves > 0)
			status = b->f->write(b, POOL_leaf, t * b->capacity[PER_COLLIDABLE], state->tree.leaves, from);
		from += state->tree.leaves;
		move(state);
		if (!status)
			status = tree_layout(pipeline, t);
	}
	return status;
}
