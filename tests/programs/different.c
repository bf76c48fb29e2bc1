// SPDX-License-Identifier: MIT
// different.c -- prints the fields of the pools in which two worlds differ, with their bits; finds invalid state of one
// world.
#include "constraints/constraint_kinds.h"
#include "programs/program.h"
#include "world/world.h"
#include <stdlib.h>
#include <string.h>

#define MOST_ITEMS 4 // maximum number of items printed for each pool

typedef struct
{
	PoolId pool;
	const char* fields[20]; // names of the words of an item, in order
} Named;

static const Named named[] = {
#define POOL_WORDS(pool, ...) {POOL_##pool, {__VA_ARGS__}},
#include "pools/pool_words.def"
};

static void print_field(FILE* file, const char* field, uint32_t a, uint32_t b)
{
	float x, y;
	memcpy(&x, &a, sizeof x);
	memcpy(&y, &b, sizeof y);
	fprintf(file, " %s %08x|%08x (%.9g|%.9g)", field, a, b, (double)x, (double)y);
}

void* read_items(scree_world* world, PoolId pool, int count)
{
	void* items = calloc((size_t)count + 1, pool_info[pool].bytes);
	if (!items)
		abort();
	world->backend->f->read(world->backend, pool, 0, count, items);
	return items;
}

static int items_of(const scree_world* world, const Counters* c, PoolId pool)
{
	Per per = pool_info[pool].per;
	return per == PER_BODY         ? world->bodies.used
	       : per == PER_COLLIDABLE ? world->collidables.used
	       : per == PER_JOINT      ? c->joints
	                               : c->contacts;
}

static void print_pool(scree_world* const worlds[2], const Named* n, int count, FILE* file)
{
	size_t bytes = pool_info[n->pool].bytes;
	char* items[2] = {read_items(worlds[0], n->pool, count), read_items(worlds[1], n->pool, count)};
	int differ = 0;
	for (int k = 0; k < count; ++k)
	{
		const char *a = items[0] + (size_t)k * bytes, *b = items[1] + (size_t)k * bytes;
		if (memcmp(a, b, bytes) == 0 || ++differ > MOST_ITEMS)
			continue;
		fprintf(file, "  %s[%d]:", pool_info[n->pool].name, k);
		for (size_t i = 0; i < bytes / 4 && n->fields[i]; ++i)
		{
			uint32_t x, y;
			memcpy(&x, a + 4 * i, sizeof x);
			memcpy(&y, b + 4 * i, sizeof y);
			if (x != y)
				print_field(file, n->fields[i], x, y);
		}
		fputc('\n', file);
	}
	if (differ > 0)
		fprintf(file, "  %s: %d of %d differ\n", pool_info[n->pool].name, differ, count);
	free(items[0]);
	free(items[1]);
}

// Prints the impulses in which two worlds differ. The impulses of a contact are stored at the place of its constraint.
static void print_impulses(scree_world* const worlds[2], const Counters counters[2], FILE* file)
{
	static const char* const fields[] = {"normal1", "normal2", "tangent1", "tangent2", "rolling"};
	int differ = 0;
	int* places[2];
	ContactRows* constraints[2];
	ContactRareRows* extras[2];
	for (int k = 0; k < 2; ++k)
	{
		int blocks = (counters[k].layout[CONSTRAINT_CONTACT].begin[COLORS + 1] + MAX_LANES - 1) / MAX_LANES;
		places[k] = read_items(worlds[k], POOL_contact_place, counters[k].contacts);
		constraints[k] = read_items(worlds[k], POOL_contact_rows, blocks);
		extras[k] = read_items(worlds[k], POOL_contact_rare_rows, blocks);
	}
	for (int i = 0; i < counters[0].contacts && i < counters[1].contacts; ++i)
	{
		if (places[0][i] < 0 || places[1][i] < 0)
			continue;
		uint32_t words[2][5];
		for (int k = 0; k < 2; ++k)
		{
			const ContactRows* c = constraints[k] + places[k][i] / MAX_LANES;
			int lane = places[k][i] % MAX_LANES;
			float values[5] = {c->normal_impulse1[lane], c->normal_impulse2[lane], c->tangent_impulse1[lane],
			                   c->tangent_impulse2[lane], extras[k][places[k][i] / MAX_LANES].rolling_impulse[lane]};
			memcpy(words[k], values, sizeof values);
		}
		if (memcmp(words[0], words[1], sizeof words[0]) == 0 || ++differ > MOST_ITEMS)
			continue;
		fprintf(file, "  impulses of contact %d:", i);
		for (int f = 0; f < 5; ++f)
			if (words[0][f] != words[1][f])
				print_field(file, fields[f], words[0][f], words[1][f]);
		fputc('\n', file);
	}
	if (differ > 0)
		fprintf(file, "  impulses: of %d contacts\n", differ);
	for (int k = 0; k < 2; ++k)
	{
		free(places[k]);
		free(constraints[k]);
		free(extras[k]);
	}
}

#define MOST_KEPT 22 // maximum number of rows of a joint that are kept from step to step

// Collects the rows that are kept from step to step, with their names, for the joint in this lane of a block. Returns
// the number of rows.
static int joint_kept(const JointRows* rows, const JointRareRows* rare, int lane, const char* names[MOST_KEPT],
                      float values[MOST_KEPT])
{
	int count = 0;
#define KEPT_ROW(name, gate, life, inert, read, written) \
	ROW_IF_KEPT_##life(names[count] = #name; values[count++] = rows->name[lane];)
#define KEPT_RARE_ROW(name, gate, life, inert, read, written) \
	ROW_IF_KEPT_##life(names[count] = #name; values[count++] = rare->name[lane];)
	JOINT_ROWS(KEPT_ROW)
	JOINT_RARE_ROWS(KEPT_RARE_ROW)
#undef KEPT_ROW
#undef KEPT_RARE_ROW
	return count;
}

typedef struct // joints of a world: places of their constraints, and rows
{
	int* places;
	JointRows* rows;
	JointRareRows* rare;
} JointsRead;

static JointsRead joints_read(scree_world* world, const Counters* c)
{
	int blocks = (c->layout[CONSTRAINT_JOINT].begin[COLORS + 1] + MAX_LANES - 1) / MAX_LANES;
	return (JointsRead){read_items(world, POOL_joint_place, c->joints), read_items(world, POOL_joint_rows, blocks),
	                    read_items(world, POOL_joint_rare_rows, blocks)};
}

static void joints_free(const JointsRead* read)
{
	free(read->places);
	free(read->rows);
	free(read->rare);
}

static void print_joints(scree_world* const worlds[2], const Counters counters[2], FILE* file)
{
	JointsRead read[2] = {joints_read(worlds[0], &counters[0]), joints_read(worlds[1], &counters[1])};
	int differ = 0;
	for (int i = 0; i < counters[0].joints && i < counters[1].joints; ++i)
	{
		const char* names[MOST_KEPT];
		float values[2][MOST_KEPT] = {{0}, {0}};
		int kept = 0;
		for (int k = 0; k < 2; ++k)
		{
			int place = read[k].places[i];
			if (place >= 0)
				kept = joint_kept(read[k].rows + place / MAX_LANES, read[k].rare + place / MAX_LANES, place % MAX_LANES,
				                  names, values[k]);
		}
		if (memcmp(values[0], values[1], sizeof values[0]) == 0 || ++differ > MOST_ITEMS)
			continue;
		fprintf(file, "  rows of joint %d:", i);
		for (int f = 0; f < kept; ++f)
		{
			uint32_t words[2];
			memcpy(&words[0], &values[0][f], sizeof words[0]);
			memcpy(&words[1], &values[1][f], sizeof words[1]);
			if (words[0] != words[1])
				print_field(file, names[f], words[0], words[1]);
		}
		fputc('\n', file);
	}
	if (differ > 0)
		fprintf(file, "  rows of joints: of %d joints\n", differ);
	joints_free(&read[0]);
	joints_free(&read[1]);
}

static bool words_finite(const char* pool, const float* words, int items, int each, char sentence[256])
{
	for (int k = 0; k < items * each; ++k)
		if (!(words[k] - words[k] == 0.0f))
		{
			snprintf(sentence, 256, "%s[%d]: word %d is %g", pool, k / each, k % each, (double)words[k]);
			return false;
		}
	return true;
}

static bool joints_finite(scree_world* world, const Counters* c, char sentence[256])
{
	JointsRead read = joints_read(world, c);
	bool finite = true;
	for (int i = 0; i < c->joints && finite; ++i)
	{
		const char* names[MOST_KEPT];
		float values[MOST_KEPT];
		int place = read.places[i];
		if (place < 0)
			continue;
		int kept =
		    joint_kept(read.rows + place / MAX_LANES, read.rare + place / MAX_LANES, place % MAX_LANES, names, values);
		for (int k = 0; k < kept && finite; ++k)
			finite = words_finite(names[k], &values[k], 1, 1, sentence);
	}
	joints_free(&read);
	return finite;
}

void different_print(scree_world* a, scree_world* b, FILE* file)
{
	scree_world* worlds[2] = {a, b};
	Counters counters[2];
	for (int k = 0; k < 2; ++k)
		worlds[k]->backend->f->read(worlds[k]->backend, POOL_counters, 0, 1, &counters[k]);
	fprintf(file, "  contacts %d and %d, touching %d and %d, frozen %d and %d\n", counters[0].contacts,
	        counters[1].contacts, counters[0].touching, counters[1].touching, counters[0].nonfinite,
	        counters[1].nonfinite);
	for (size_t k = 0; k < sizeof named / sizeof named[0]; ++k)
	{
		int count = items_of(a, &counters[0], named[k].pool), other = items_of(b, &counters[1], named[k].pool);
		print_pool(worlds, &named[k], count < other ? count : other, file);
	}
	print_impulses(worlds, counters, file);
	print_joints(worlds, counters, file);
}

int state_frozen(scree_world* world)
{
	Counters counters;
	world->backend->f->read(world->backend, POOL_counters, 0, 1, &counters);
	return counters.nonfinite;
}

// Pools that are part of the state and contain only floats.
static const PoolId states[] = {
    POOL_body, POOL_pose, POOL_pose_low, POOL_motion, POOL_local_center, POOL_collidable_pose, POOL_contact_surface};

bool state_finite(scree_world* world, char sentence[256])
{
	Counters c;
	world->backend->f->read(world->backend, POOL_counters, 0, 1, &c);
	bool finite = true;
	for (size_t k = 0; k < sizeof states / sizeof states[0] && finite; ++k)
	{
		int count = items_of(world, &c, states[k]);
		float* items = read_items(world, states[k], count);
		finite = words_finite(pool_info[states[k]].name, items, count, (int)(pool_info[states[k]].bytes / 4), sentence);
		free(items);
	}

	// checks only collidables that are not destroyed
	int* kinds = read_items(world, POOL_collidable_kind, world->collidables.used);
	Float4* boxes = read_items(world, POOL_box, world->collidables.used);
	WorldShape* placed = read_items(world, POOL_world_shape, world->collidables.used);
	for (int k = 0; k < world->collidables.used && finite; ++k)
		if (kinds[k] != KIND_DEAD)
			finite = words_finite("box", &boxes[k].x, 1, 4, sentence) &&
			         words_finite("placed", &placed[k].x, 1, 6, sentence);
	Int2* pairs = read_items(world, POOL_pair, c.contacts);
	LocalManifold* found = read_items(world, POOL_contact_manifold, c.contacts);
	int* places = read_items(world, POOL_contact_place, c.contacts);
	int blocks = (c.layout[CONSTRAINT_CONTACT].begin[COLORS + 1] + MAX_LANES - 1) / MAX_LANES;
	ContactRows* constraints = read_items(world, POOL_contact_rows, blocks);
	ContactRareRows* extras = read_items(world, POOL_contact_rare_rows, blocks);
	for (int k = 0; k < c.contacts && finite; ++k)
	{
		if (pairs[k].x < 0)
			continue;
		finite = words_finite("contact_manifold", &found[k].normal.x, 1, 16, sentence);
		if (places[k] < 0 || !finite)
			continue;
		const ContactRows* block = constraints + places[k] / MAX_LANES;
		int lane = places[k] % MAX_LANES;
		float impulses[] = {block->normal_impulse1[lane], block->normal_impulse2[lane], block->tangent_impulse1[lane],
		                    block->tangent_impulse2[lane], extras[places[k] / MAX_LANES].rolling_impulse[lane]};
		finite = words_finite("impulses", impulses, 1, 5, sentence);
	}
	void* all[] = {kinds, boxes, placed, pairs, found, places, constraints, extras};
	for (size_t k = 0; k < sizeof all / sizeof all[0]; ++k)
		free(all[k]);
	return finite && joints_finite(world, &c, sentence);
}

bool state_limited(scree_world* world, char sentence[256])
{
	// tolerance for rounding
	double slack = 1.0 + 1e-5, speed = world->def.max_speed * slack, spin = world->pipeline.step.max_spin * slack;
	BodyState* bodies = read_items(world, POOL_body, world->bodies.used);
	bool limited = true;
	for (int k = 0; k < world->bodies.used && limited; ++k)
	{
		double vx = bodies[k].vx, vy = bodies[k].vy, w = bodies[k].w;
		limited = vx * vx + vy * vy <= speed * speed && w >= -spin && w <= spin;
		if (!limited)
			snprintf(sentence, 256, "body %d goes at (%g, %g) m/s and turns at %g rad/s; limits are %g and %g", k, vx,
			         vy, w, speed, spin);
	}
	free(bodies);
	return limited;
}
