// SPDX-License-Identifier: MIT
// test_broad_phase.c -- checks that after every step the contacts are exactly the pairs found by a comparison of all
// pairs.
//
// Formula: {pairs of the contact pool} = {pairs of collidables that exist, are not on the same body, and have enlarged
// boxes that overlap, filters that agree and kinds that can touch}. Boxes are read from the device; lifetime, filter,
// kind and body come from the public interface. The test also checks that each box contains the whole shape at the pose
// that the stage transform computed.
#include "support/different_pools.h"
#include "support/make_bodies.h"
#include "support/variants.h"
#include "tools/common/random_numbers.h"
#include "world/objects/handles.h"
#include "world/world.h"
#include <stdlib.h>
#include <string.h>

typedef struct // state of a collidable from the public interface, and its enlarged box from the device
{
	bool alive, has_body, moves, fixed; // moves: the body is dynamic; fixed: the body is static
	scree_body body;
	scree_filter filter;
	Float4 box;
} Item;

typedef struct
{
	const char* name;
	void (*build)(scree_world* world, uint64_t* seed);
	scree_vec center, half; // center and half size of the area in which changes place bodies, m
	int steps, changes;     // changes: number of changes before each step
} Layout;

// ---------------------------------------------------------------------------------------------------------------
// comparison of all pairs with the contact pool
// ---------------------------------------------------------------------------------------------------------------

static bool overlap(Float4 a, Float4 b) { return a.x <= b.z && b.x <= a.z && a.y <= b.w && b.y <= a.w; }

static bool filters_agree(scree_filter a, scree_filter b)
{
	if (a.group != 0 && a.group == b.group)
		return a.group > 0;
	return (a.category & b.mask) && (b.category & a.mask);
}

// Returns whether two collidables must be a pair. At least one of the two must be dynamic or have no body, because a
// collidable without a body reports overlaps with all others.
static bool is_pair(const Item* a, const Item* b)
{
	bool same_body = a->has_body && b->has_body && a->body.index == b->body.index;
	bool meet = a->moves || b->moves || !a->has_body || !b->has_body;
	return a->alive && b->alive && !same_body && meet && overlap(a->box, b->box) && filters_agree(a->filter, b->filter);
}

// Checks in double precision that the box of a collidable contains each corner of its shape, with a margin of the
// radius.
static void check_box(scree_world* world, const Item* item, const WorldShape* placed, int index)
{
	scree_attribute attribute;
	scree_attribute_def def;
	OK(scree_collidable_get_attribute(world, collidable_handle(world, index), &attribute));
	OK(scree_attribute_get_def(world, attribute, &def));
	for (int k = 0; k < def.shape.count; ++k)
	{
		scree_vec v = def.shape.vertices[k];
		double x = placed->x + ((double)placed->c * v.x - (double)placed->s * v.y), r = def.shape.radius;
		double y = placed->y + ((double)placed->s * v.x + (double)placed->c * v.y);
		if (x - r < item->box.x || x + r > item->box.z || y - r < item->box.y || y + r > item->box.w)
			fail_msg("the box of collidable %d does not hold its corner %d at %g, %g", index, k, x, y);
	}
}

static Item* list_items(scree_world* world, int count)
{
	Item* items = calloc((size_t)count + 1, sizeof *items);
	Float4* boxes = read_pool(world, POOL_box, count);
	WorldShape* placed = read_pool(world, POOL_world_shape, count);
	for (int k = 0; k < count; ++k)
	{
		Item* item = items + k;
		scree_collidable handle = collidable_handle(world, k);
		item->alive = scree_collidable_is_valid(world, handle);
		item->box = boxes[k];
		if (!item->alive)
			continue;
		OK(scree_collidable_get_filter(world, handle, &item->filter));
		OK(scree_collidable_get_body(world, handle, &item->body));
		item->has_body = item->body.index != 0;
		scree_body_type type = SCREE_BODY_KINEMATIC;
		if (item->has_body)
			OK(scree_body_get_type(world, item->body, &type));
		item->moves = item->has_body && type == SCREE_BODY_DYNAMIC;
		item->fixed = item->has_body && type == SCREE_BODY_STATIC;
		check_box(world, item, placed + k, k);
	}
	free(boxes);
	free(placed);
	return items;
}

static int compare_keys(const void* a, const void* b)
{
	uint64_t x = *(const uint64_t*)a, y = *(const uint64_t*)b;
	return (x > y) - (x < y);
}

static void print_pair(const char* what, const Item* items, uint64_t key)
{
	print_error("%s: ", what);
	for (int side = 0; side < 2; ++side)
	{
		int k = (int)(side ? key & 0xffffffffu : key >> 32);
		const Item* item = items + k;
		print_error("%d (%s, body %u, box %g %g %g %g)%s", k,
		            !item->alive  ? "dead"
		            : item->moves ? "dynamic"
		            : item->fixed ? "static"
		                          : "other",
		            item->body.index, item->box.x, item->box.y, item->box.z, item->box.w, side ? "\n" : " and ");
	}
}

static int check_pairs(scree_world* world, const char* name, int step)
{
	int count = world->collidables.used, found = 0, expected = 0, room = 1024;
	int alive = counters_of(world).contacts, slots = world->pipeline.counters.contacts;
	Item* items = list_items(world, count);
	Int2* pairs = read_pool(world, POOL_pair, slots);
	uint64_t* have = malloc(sizeof(uint64_t) * ((size_t)slots + 1));
	uint64_t* want = malloc(sizeof(uint64_t) * (size_t)room);
	for (int k = 0; k < slots; ++k)
		if (pairs[k].x >= 0)
		{
			// pairs[k].x is the dynamic collidable of a pair, or the smaller index; in the key, the smaller index
			// always comes first
			int a = pairs[k].x < pairs[k].y ? pairs[k].x : pairs[k].y, b = pairs[k].x ^ pairs[k].y ^ a;
			have[found++] = (uint64_t)a << 32 | (uint64_t)b;
		}
	qsort(have, (size_t)found, sizeof *have, compare_keys);
	for (int a = 0; a < count; ++a)
		for (int b = a + 1; b < count && items[a].alive; ++b)
			if (is_pair(items + a, items + b))
			{
				if (expected == room)
					want = realloc(want, sizeof(uint64_t) * (size_t)(room *= 2));
				want[expected++] = (uint64_t)a << 32 | (uint64_t)b;
			}

	// finds differences between the pairs of the pool and the expected pairs; both lists are sorted
	int wrong = 0;
	for (int i = 0, j = 0; i < found || j < expected;)
	{
		bool same = i < found && j < expected && have[i] == want[j];
		bool extra = !same && i < found && (j == expected || have[i] < want[j]);
		if (!same && wrong++ < 5)
			print_pair(extra ? "has" : "lacks", items, extra ? have[i] : want[j]);
		i += same || extra;
		j += !extra;
	}
	if (wrong > 0)
		fail_msg("%s, step %d: %d of %d pairs are wrong", name, step, wrong, expected);
	assert_int_equal(alive, expected);
	free(items);
	free(pairs);
	free(have);
	free(want);
	return expected;
}

// ---------------------------------------------------------------------------------------------------------------
// layouts
// ---------------------------------------------------------------------------------------------------------------

static scree_body put(scree_world* world, uint64_t* seed, scree_body_type type, scree_shape shape, float x, float y)
{
	scree_body_def def = scree_body_def_default();
	def.type = type;
	def.attribute = shape_attribute(world, shape);
	def.pose.position = (scree_vec){x, y};
	if (type != SCREE_BODY_STATIC)
		def.velocity.linear = (scree_vec){random_between(seed, -8.0f, 8.0f), random_between(seed, -8.0f, 8.0f)};
	return create_body(world, &def);
}

static scree_shape any_shape(uint64_t* seed)
{
	switch (random_below(seed, 3))
	{
	case 0:
		return box_shape(0.5f, 0.3f);
	case 1:
		return circle_shape(0.4f);
	default:
		return box_shape(0.1f, 1.5f);
	}
}

static void build_random(scree_world* world, uint64_t* seed)
{
	for (int k = 0; k < 250; ++k)
	{
		scree_body_type type = (scree_body_type)(random_below(seed, 5) % 3);
		put(world, seed, type, any_shape(seed), random_between(seed, -12.0f, 12.0f),
		    random_between(seed, -12.0f, 12.0f));
	}
}

static void build_point(scree_world* world, uint64_t* seed)
{
	for (int k = 0; k < 90; ++k)
		put(world, seed, SCREE_BODY_DYNAMIC, any_shape(seed), 0.0f, 0.0f);
}

static scree_filter any_filter(uint64_t* seed)
{
	static const uint64_t masks[] = {UINT64_MAX, UINT64_MAX, 3, 2, 1ull << 63};
	static const uint64_t categories[] = {1, 1, 2, 1ull << 63};
	return (scree_filter){.category = categories[random_below(seed, 4)],
	                      .mask = masks[random_below(seed, 5)],
	                      .group = random_below(seed, 2) ? 0 : random_below(seed, 5) - 2};
}

// all collidables are close together, so that only filters decide
static void build_filters(scree_world* world, uint64_t* seed)
{
	for (int k = 0; k < 80; ++k)
	{
		scree_body body =
		    put(world, seed, SCREE_BODY_DYNAMIC, any_shape(seed), 0.1f * (float)(k % 9), 0.1f * (float)(k / 9));
		scree_collidable part = collidable_of(world, body);
		OK(scree_collidable_set_filter(world, part, any_filter(seed)));
	}
}

// one body that is as large as the area, among tiny bodies
static void build_huge(scree_world* world, uint64_t* seed)
{
	put(world, seed, SCREE_BODY_DYNAMIC, box_shape(60.0f, 60.0f), 0.0f, 0.0f);
	for (int k = 0; k < 400; ++k)
		put(world, seed, SCREE_BODY_DYNAMIC, circle_shape(0.05f), random_between(seed, -50.0f, 50.0f),
		    random_between(seed, -70.0f, 70.0f));
}

// six large bodies among small ones; the traversals of the large bodies are so long that each is divided into several,
// in the tree of static collidables and in the other tree
static void build_huges(scree_world* world, uint64_t* seed)
{
	for (int k = 0; k < 6; ++k)
		put(world, seed, k % 2 ? SCREE_BODY_KINEMATIC : SCREE_BODY_DYNAMIC, box_shape(60.0f, 4.0f + 8.0f * (float)k),
		    random_between(seed, -5.0f, 5.0f), random_between(seed, -5.0f, 5.0f));
	for (int k = 0; k < 2400; ++k)
		put(world, seed, k % 3 ? SCREE_BODY_DYNAMIC : SCREE_BODY_STATIC, circle_shape(0.05f),
		    random_between(seed, -50.0f, 50.0f), random_between(seed, -50.0f, 50.0f));
}

static void build_line(scree_world* world, uint64_t* seed)
{
	for (int k = 0; k < 500; ++k)
		put(world, seed, SCREE_BODY_DYNAMIC, box_shape(0.5f, 0.5f), 1.01f * (float)k, 0.0f);
}

static void build_ring(scree_world* world, uint64_t* seed)
{
	for (int k = 0; k < 400; ++k)
	{
		scree_rot turn = scree_rot_make((float)(2.0 * PI / 400.0) * (float)k);
		put(world, seed, SCREE_BODY_DYNAMIC, circle_shape(0.5f), 60.0f * turn.c, 60.0f * turn.s);
	}
}

// bodies so far from the origin that adjacent floats are 8 mm apart
static void build_far(scree_world* world, uint64_t* seed)
{
	put(world, seed, SCREE_BODY_STATIC, box_shape(30.0f, 1.0f), 90000.0f, -90001.0f);
	for (int k = 0; k < 200; ++k)
		put(world, seed, SCREE_BODY_DYNAMIC, any_shape(seed), 90000.0f + random_between(seed, -12.0f, 12.0f),
		    -90000.0f + random_between(seed, 0.0f, 12.0f));
}

static void build_ground(scree_world* world, uint64_t* seed)
{
	put(world, seed, SCREE_BODY_STATIC, box_shape(500.0f, 1.0f), 0.0f, -1.0f);
	for (int k = 0; k < 400; ++k)
		put(world, seed, SCREE_BODY_DYNAMIC, box_shape(0.5f, 0.5f), 1.02f * (float)(k % 40) - 20.0f,
		    0.5f + (float)(k / 40));
	for (int k = 0; k < 100; ++k)
		put(world, seed, SCREE_BODY_STATIC, box_shape(0.2f, 0.2f), (float)k - 50.0f, 12.0f);
}

static void build_statics(scree_world* world, uint64_t* seed)
{
	for (int k = 0; k < 3000; ++k)
		put(world, seed, SCREE_BODY_STATIC, box_shape(0.3f, 0.3f), (float)(k % 60) - 30.0f, (float)(k / 60) - 25.0f);
	for (int k = 0; k < 100; ++k)
		put(world, seed, SCREE_BODY_DYNAMIC, circle_shape(0.3f), random_between(seed, -30.0f, 30.0f),
		    random_between(seed, -25.0f, 25.0f));
}

// bodies with several collidables; two collidables of the same body must not make a pair
static void build_compound(scree_world* world, uint64_t* seed)
{
	for (int k = 0; k < 60; ++k)
	{
		scree_body body = put(world, seed, k % 4 ? SCREE_BODY_DYNAMIC : SCREE_BODY_KINEMATIC, any_shape(seed),
		                      random_between(seed, -8.0f, 8.0f), random_between(seed, -8.0f, 8.0f));
		for (int part = 0; part < 4; ++part)
		{
			scree_attribute_def surface = surface_of(any_shape(seed));
			scree_collidable_def def = scree_collidable_def_default();
			def.attribute = add_attribute(world, &surface);
			def.body = body;
			def.pose.position = (scree_vec){0.5f * (float)part, random_between(seed, -0.5f, 0.5f)};
			def.pose.rotation = scree_rot_make((float)part);
			OK(scree_collidable_create(world, &def, NULL));
		}
	}
}

// kinematic bodies with many collidables among a few dynamic bodies; traversals of kinematic collidables skip nodes
// that contain no dynamic collidable; changes of type between steps add dynamic collidables to such nodes
static void build_kinematic(scree_world* world, uint64_t* seed)
{
	scree_collidable_def def = scree_collidable_def_default();
	def.attribute = shape_attribute(world, box_shape(0.5f, 0.5f));
	for (int k = 0; k < 12; ++k)
	{
		def.body =
		    put(world, seed, SCREE_BODY_KINEMATIC, any_shape(seed), 6.0f * (float)(k % 4), 6.0f * (float)(k / 4));
		for (int part = 0; part < 49; ++part)
		{
			def.pose.position = (scree_vec){(float)(part % 7), (float)(part / 7)};
			OK(scree_collidable_create(world, &def, NULL));
		}
	}
	for (int k = 0; k < 30; ++k)
		put(world, seed, SCREE_BODY_DYNAMIC, any_shape(seed), random_between(seed, 0.0f, 24.0f),
		    random_between(seed, 0.0f, 18.0f));
}

static scree_collidable add_free(scree_world* world, uint64_t* seed, float x, float y)
{
	scree_attribute_def surface = surface_of(any_shape(seed));
	scree_collidable_def def = scree_collidable_def_default();
	def.attribute = add_attribute(world, &surface);
	def.pose.position = (scree_vec){x, y};
	return create_collidable(world, &def);
}

// collidables without a body among bodies of all types
static void build_free(scree_world* world, uint64_t* seed)
{
	build_random(world, seed);
	for (int k = 0; k < 60; ++k)
		add_free(world, seed, random_between(seed, -12.0f, 12.0f), random_between(seed, -12.0f, 12.0f));
}

static void build_nothing(scree_world* world, uint64_t* seed)
{
	(void)world;
	(void)seed;
}

// ---------------------------------------------------------------------------------------------------------------
// changes between steps
// ---------------------------------------------------------------------------------------------------------------

static scree_vec any_place(const Layout* layout, uint64_t* seed)
{
	scree_vec c = layout->center, h = layout->half;
	float x = random_between(seed, -1.0f, 1.0f), y = random_between(seed, -1.0f, 1.0f);
	return (scree_vec){c.x + h.x * x, c.y + h.y * y};
}

static void change_body(scree_world* world, const Layout* layout, scree_body body, uint64_t* seed)
{
	scree_vec place = any_place(layout, seed);
	scree_pose pose = {place, scree_rot_make(random_between(seed, -3.0f, 3.0f))}, back;
	scree_body_type type;
	scree_collidable parts[64];
	int count;
	OK(scree_body_get_type(world, body, &type));
	OK(scree_body_get_collidables(world, body, parts, 64, &count));
	switch (random_below(seed, 10))
	{
	case 0: // another body takes the slot, at the same place
		back = pose_of(world, body);
		OK(scree_body_destroy(world, body));
		put(world, seed, type, any_shape(seed), back.position.x, back.position.y);
		break;
	case 1:
		OK(scree_body_destroy(world, body));
		break;
	case 2:
		OK(scree_body_set_pose(world, body, pose));
		break;
	case 3: // moves the body away and back
		back = pose_of(world, body);
		OK(scree_body_set_pose(world, body, pose));
		OK(scree_body_set_pose(world, body, back));
		break;
	case 4:
		OK(scree_body_set_type(world, body, (scree_body_type)random_below(seed, 3)));
		break;
	case 5:
		OK(scree_body_set_type(world, body, (scree_body_type)random_below(seed, 3)));
		OK(scree_body_set_pose(world, body, pose));
		OK(scree_body_set_type(world, body, type));
		break;
	case 6:
		if (count > 0)
			OK(scree_collidable_set_filter(world, parts[random_below(seed, count)], any_filter(seed)));
		break;
	case 7:
		if (count > 0)
			OK(scree_collidable_destroy(world, parts[random_below(seed, count)]));
		break;
	case 8:
	{
		scree_attribute_def surface = surface_of(any_shape(seed));
		scree_collidable_def def = scree_collidable_def_default();
		def.attribute = add_attribute(world, &surface);
		def.body = body;
		def.filter = any_filter(seed);
		OK(scree_collidable_create(world, &def, NULL));
		break;
	}
	default:
		put(world, seed, (scree_body_type)random_below(seed, 3), any_shape(seed), place.x, place.y);
	}
}

static void change_free(scree_world* world, const Layout* layout, uint64_t* seed)
{
	scree_collidable list[256];
	int count;
	OK(scree_body_get_collidables(world, (scree_body){0, 0}, list, 256, &count));
	scree_vec place = any_place(layout, seed);
	scree_pose pose = {place, scree_rot_make(random_between(seed, -3.0f, 3.0f))};
	int pick = count > 0 ? random_below(seed, count) : 0, what = count > 0 ? random_below(seed, 5) : 0;
	if (what == 0)
		add_free(world, seed, place.x, place.y);
	else if (what == 1)
		OK(scree_collidable_destroy(world, list[pick]));
	else if (what == 2)
		OK(scree_collidable_set_filter(world, list[pick], any_filter(seed)));
	else
		OK(scree_collidables_set_poses(world, list + pick, &pose, 1));
}

static void change(scree_world* world, const Layout* layout, uint64_t* seed)
{
	for (int k = 0; k < layout->changes; ++k)
	{
		scree_body bodies[4096];
		int count;
		OK(scree_world_get_bodies(world, bodies, 4096, &count));
		scree_vec place = any_place(layout, seed);
		if (random_below(seed, 5) == 0)
			change_free(world, layout, seed);
		else if (count == 0)
			put(world, seed, SCREE_BODY_DYNAMIC, any_shape(seed), place.x, place.y);
		else
			change_body(world, layout, bodies[random_below(seed, count)], seed);

		// hash_of uploads all pending changes, so there may be several uploads before a step
		if (random_below(seed, 6) == 0)
			hash_of(world);
	}
}

// Creates 300 bodies in one step, and destroys almost all bodies in a later one.
static void burst(scree_world* world, const Layout* layout, int step, uint64_t* seed)
{
	scree_body bodies[4096];
	int count;
	OK(scree_world_get_bodies(world, bodies, 4096, &count));
	if (step == layout->steps / 2)
		for (int k = 0; k < 300; ++k)
		{
			scree_vec place = any_place(layout, seed);
			put(world, seed, k % 2 ? SCREE_BODY_DYNAMIC : SCREE_BODY_STATIC, any_shape(seed), place.x, place.y);
		}
	else if (step == 3 * layout->steps / 4 && count > 10)
		OK(scree_bodies_destroy(world, bodies + 5, count - 10));
}

// ---------------------------------------------------------------------------------------------------------------
// tests
// ---------------------------------------------------------------------------------------------------------------

static const Layout layouts[] = {
    {"random", build_random, {0.0f, 0.0f}, {12.0f, 12.0f}, 40, 8},
    {"one_point", build_point, {0.0f, 0.0f}, {1.0f, 1.0f}, 12, 4},
    {"filters", build_filters, {0.0f, 0.0f}, {2.0f, 2.0f}, 16, 4},
    {"one_huge", build_huge, {0.0f, 0.0f}, {60.0f, 70.0f}, 24, 4},
    {"huge_ones", build_huges, {0.0f, 0.0f}, {60.0f, 60.0f}, 16, 4},
    {"line", build_line, {250.0f, 0.0f}, {250.0f, 1.0f}, 24, 4},
    {"ring", build_ring, {0.0f, 0.0f}, {60.0f, 60.0f}, 24, 4},
    {"far", build_far, {90000.0f, -90000.0f}, {12.0f, 12.0f}, 24, 4},
    {"ground", build_ground, {0.0f, 5.0f}, {20.0f, 8.0f}, 24, 4},
    {"statics", build_statics, {0.0f, 0.0f}, {30.0f, 25.0f}, 24, 4},
    {"compound", build_compound, {0.0f, 0.0f}, {8.0f, 8.0f}, 24, 4},
    {"kinematic", build_kinematic, {12.0f, 9.0f}, {12.0f, 9.0f}, 40, 4},
    {"free", build_free, {0.0f, 0.0f}, {12.0f, 12.0f}, 40, 8},
    {"nothing", build_nothing, {0.0f, 0.0f}, {2.0f, 2.0f}, 60, 1},
};

static void run_layout(const Layout* layout, const Variant* variant)
{
	scree_world* world = open_default_variant(variant);
	uint64_t seed = 77;
	layout->build(world, &seed);
	int steps = quick() ? layout->steps / 2 : layout->steps, most = 0, traversals = 0;
	for (int step = 0; step < steps; ++step)
	{
		// nothing is changed before the first four steps, so that a wrong pair in these steps is not due to a change
		if (step >= 4)
			change(world, layout, &seed);
		burst(world, layout, step, &seed);
		OK(scree_world_step(world, STEP, SUBSTEPS));
		int pairs = check_pairs(world, layout->name, step);
		most = pairs > most ? pairs : most;
		traversals += world->pipeline.counters.traversals;
	}
	print_message("%s on %s: up to %d pairs, %d long traversals\n", layout->name, variant->name, most, traversals);
	assert_true(layout->build != build_huges || variant->threads == 1 || traversals > 0);
	scree_world_destroy(world);
}

static void pairs_are_complete(void** state)
{
	const Variant alone = {.name = "one thread", .device = "cpu", .threads = 1},
	              both = {.name = "two threads", .device = "cpu", .threads = 2};
	run_layout(*state, &alone);
	run_layout(*state, &both);
}

static void pairs_are_complete_on_opencl(void** state)
{
	Variant variants[MAX_VARIANTS];
	int count = list_variants(variants), found = 0;
	for (int k = 0; k < count; ++k)
		if (variants[k].form == FORM_LAUNCHES)
		{
			++found;
			run_layout(layouts, variants + k);
			for (size_t l = 0; l < sizeof layouts / sizeof *layouts; ++l)
				if (layouts[l].build == build_huges || layouts[l].build == build_kinematic)
					run_layout(layouts + l, variants + k);
			run_layout(*state, variants + k);
		}
	if (found == 0)
		skip();
}

int main(void)
{
	enum
	{
		COUNT_OF_LAYOUTS = sizeof layouts / sizeof *layouts
	};
	struct CMUnitTest tests[COUNT_OF_LAYOUTS + 1];
	for (int k = 0; k < COUNT_OF_LAYOUTS; ++k)
		tests[k] = (struct CMUnitTest){layouts[k].name, pairs_are_complete, NULL, NULL, (void*)&layouts[k]};
	tests[COUNT_OF_LAYOUTS] =
	    (struct CMUnitTest){"opencl", pairs_are_complete_on_opencl, NULL, NULL, (void*)&layouts[COUNT_OF_LAYOUTS - 2]};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
