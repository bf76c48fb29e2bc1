// SPDX-License-Identifier: MIT
// test_idle.c -- checks that a CPU may skip blocks of static bodies: after changes of all kinds, the bits are the same
// as in a world that skips no block.
#include "support/make_bodies.h"
#include "tools/common/random_numbers.h"
#include "world/device/idle.h"
#include "world/world.h"
#include <stdlib.h>

enum
{
	STATICS = 1500,
	MOVERS = 40,
	KINDS = 12
};

typedef struct // two worlds that get the same calls; the second world never skips a block
{
	scree_world* worlds[2];
	scree_body statics[2][STATICS], movers[2][MOVERS];
	scree_collidable free[2];
	int left_out; // number of steps in which the first world skipped static blocks
} Level;

// Creates floors of boxes in rows, and boxes that fall on them.
static void open_level(Level* level, int threads)
{
	*level = (Level){0};
	for (int w = 0; w < 2; ++w)
	{
		scree_world* world = level->worlds[w] = stay_awake(open_world_on("cpu", threads, (float)-G));
		for (int k = 0; k < STATICS; ++k)
			level->statics[w][k] = add_crate(world, SCREE_BODY_STATIC, (float)(k % 50), -3.0f * (float)(k / 50));
		for (int k = 0; k < MOVERS; ++k)
			level->movers[w][k] = add_crate(world, SCREE_BODY_DYNAMIC, 1.3f * (float)k, 1.5f);
		scree_collidable_def def = scree_collidable_def_default();
		def.attribute = box_attribute(world, 0.5f, 0.5f);
		def.pose.position.y = 1.0f;
		level->free[w] = create_collidable(world, &def);
	}
}

static void close_level(Level* level)
{
	for (int w = 0; w < 2; ++w)
		scree_world_destroy(level->worlds[w]);
}

static void advance(Level* level, int steps)
{
	for (int k = 0; k < steps; ++k)
	{
		uint64_t hashes[2];
		idle_forget(level->worlds[1]);
		for (int w = 0; w < 2; ++w)
		{
			OK(scree_world_step(level->worlds[w], k % 7 == 6 ? 0.0f : STEP, 4));
			hashes[w] = hash_of(level->worlds[w]);
		}
		level->left_out += level->worlds[0]->backend->active[ACTIVE_COLLIDABLES].blocks != NULL;
		assert_null(level->worlds[1]->backend->active[ACTIVE_COLLIDABLES].blocks);
		if (hashes[0] != hashes[1])
			fail_msg("step %d after the change has other bits", k);
	}
}

// Changes static body k of world w, or the collidable of this world that has no body. kind: selects the change.
static void change(Level* level, int w, int kind, int k)
{
	scree_world* world = level->worlds[w];
	scree_body* body = &level->statics[w][k];
	scree_pose pose = pose_of(world, *body);
	scree_collidable collidable = collidable_of(world, *body);
	pose.position.y += 0.4f;
	switch (kind)
	{
	case 0:
		OK(scree_body_set_pose(world, *body, pose));
		break;
	case 1:
	case 2:
		OK(scree_body_set_type(world, *body, kind == 1 ? SCREE_BODY_DYNAMIC : SCREE_BODY_KINEMATIC));
		throw_body(world, *body, 1.0f, 2.0f, 3.0f);
		break;
	case 3:
		OK(scree_body_set_enabled(world, *body, false));
		break;
	case 4:
		OK(scree_body_destroy(world, *body));
		*body = add_crate(world, SCREE_BODY_STATIC, pose.position.x, pose.position.y);
		break;
	case 5:
		OK(scree_body_destroy(world, *body));
		*body = add_crate(world, SCREE_BODY_DYNAMIC, pose.position.x, pose.position.y + 3.0f);
		break;
	case 6:
		OK(scree_collidable_set_attribute(world, collidable, box_attribute(world, 0.7f, 0.6f)));
		break;
	case 7:
		OK(scree_collidable_set_filter(world, collidable, (scree_filter){.category = 2, .mask = 0}));
		break;
	case 8:
		OK(scree_collidables_set_poses(world, &level->free[w], &pose, 1));
		break;
	case 9:
		throw_body(world, *body, 1.0f, 2.0f, 3.0f);
		OK(scree_body_apply_force(world, *body, (scree_vec){100.0f, 100.0f}));
		break;
	case 10:
		OK(scree_body_set_damping(world, *body, 0.5f, 0.5f));
		break;
	default:
		OK(scree_body_set_locks(world, *body, SCREE_LOCK_X));
	}
}

// Makes each kind of change twice in a level at rest. If the first change set a type or disabled a body, the second one
// makes the body static again or enables it.
static void changes_are_seen(void** state)
{
	(void)state;
	for (int threads = 1; threads <= 2; ++threads)
	{
		Level level;
		open_level(&level, threads);
		advance(&level, 40);
		assert_true(level.left_out > 30);
		for (int kind = 0; kind < KINDS; ++kind)
			for (int again = 0; again < 2; ++again)
			{
				for (int w = 0; w < 2; ++w)
				{
					int k = 7 * kind % 50;
					if (again && (kind == 1 || kind == 2))
						OK(scree_body_set_type(level.worlds[w], level.statics[w][k], SCREE_BODY_STATIC));
					else if (again && kind == 3)
						OK(scree_body_set_enabled(level.worlds[w], level.statics[w][k], true));
					else
						change(&level, w, kind, k);
				}
				advance(&level, 9);
			}
		close_level(&level);
	}
}

// Makes random changes between steps, and sometimes moves the first world to the CPU, although it is there already.
static void random_changes(void** state)
{
	(void)state;
	uint64_t seed = 5;
	Level level;
	open_level(&level, 2);
	for (int k = 0; k < 150; ++k)
	{
		for (int n = random_below(&seed, 3); n > 0; --n)
		{
			int kind = random_below(&seed, KINDS), at = random_below(&seed, STATICS);
			for (int w = 0; w < 2; ++w)
				change(&level, w, kind, at);
		}
		if (k % 50 == 30)
			OK(scree_world_move(level.worlds[0], "cpu"));
		advance(&level, 1 + random_below(&seed, 4));
	}
	close_level(&level);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(changes_are_seen), cmocka_unit_test(random_changes)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
