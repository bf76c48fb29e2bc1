// SPDX-License-Identifier: MIT
// test_tiles.c -- checks the tiles of OpenCL, compiled as C with 16 bodies per tile. A seed decides the order in which
// work-items take turns.
//
// Formula: hash(tiles, seed, step) = hash(cpu, step) for each step, and all words of mailboxes are 0 after a solve. If
// a work-item at the border of a tile never gets a turn, all others end with a fault.
#include "batch/batch.h"
#include "emulation/emulated_forms.h"
#include "emulation/emulation_scenes.h"
#include "support/checks.h"
#include "support/make_bodies.h"
#include "support/make_joints.h"

static const Form forms[] = {
    {.name = "tiles", .tiles = true, .groups = 8},
    {.name = "tiles, few groups, late words", .tiles = true, .groups = 2, .schedule = {.late = true, .pieces = 8}},
    {.name = "tiles, ahead", .tiles = true, .groups = 4, .ahead = true, .schedule.late = true},
};

static void tiles_are_equal(void** state)
{
	(void)state;
	int tiles = 0, inner = 0, border = 0, kept = 0;
	for (size_t k = 0; k < sizeof forms / sizeof *forms; ++k)
		for (int scene = 0; scene < form_scene_count; ++scene)
			for (int seed = 1; seed <= form_seeds((int)k, scene) && !form_scenes[scene].hubs; ++seed)
			{
				Form form = forms[k];
				form.schedule.seed = 1000033u * (uint64_t)seed + k;
				check_form(&form_scenes[scene], &form);
				kept += form_counts.kept;
				tiles = form_counts.tiles > tiles ? form_counts.tiles : tiles;
				inner = form_counts.inner > inner ? form_counts.inner : inner;
				border = form_counts.border > border ? form_counts.border : border;
			}
	assert_true(tiles > 3 && inner > 32 && border > 128 && kept > 10);
}

static void shunned_groups_are_found(void** state)
{
	(void)state;
	for (int group = 1; group <= 4; ++group)
		check_fault("pyramid", (Form){.name = "tiles", .tiles = true, .groups = 4, .schedule.shunned = group});
}

static void lost_words_are_found(void** state)
{
	(void)state;
	check_lost("pyramid", (Form){.name = "tiles", .tiles = true, .groups = 3});
	check_lost("joints", (Form){.name = "tiles, joints", .tiles = true, .groups = 3});
	check_lost("heap", (Form){.name = "tiles, late words", .tiles = true, .groups = 8, .schedule.late = true});
}

#define BAYS 11 // number of worlds of a batch

// Opens a world of crates without sleep. joints: 0 for none, 1 for hinges, 2 for springs.
static scree_world* open_level(int joints)
{
	scree_world_def def = scree_world_def_default();
	def.device = "cpu";
	def.threads = 1;
	def.sleep = false;
	scree_world* world = create_world(&def);
	scree_body bodies[7];
	for (int k = 0; k < 7; ++k)
	{
		scree_body_def crate =
		    crate_def(world, k == 0 ? SCREE_BODY_STATIC : SCREE_BODY_DYNAMIC, 0.3f * (float)(k % 2), 1.01f * (float)k);
		OK(scree_body_create(world, &crate, bodies + k));
	}
	for (int k = 4; k < 6 && joints > 0; ++k)
	{
		scree_joint_def hinge =
		    joint_def_at(world, SCREE_JOINT_REVOLUTE, bodies[k], bodies[k + 1], 0.2f, 1.01f * (float)k + 0.5f, 0.0f);
		if (joints == 2)
			hinge.coordinates[SCREE_ANGLE].spring_hertz = 3.0f;
		add_joint(world, &hinge);
	}
	return world;
}

// The solve of a batch in one launch has the bits of each world alone. varied: true if worlds with odd numbers have another
// gravity than the others.
static void check_bays(bool varied)
{
	for (int joints = 0; joints < 3; ++joints)
		for (int seed = 1; seed <= 3; ++seed)
		{
			scree_world *level = open_level(joints), *pulled = open_level(joints);
			scree_batch_def def = scree_batch_def_default();
			scree_batch* batch;
			uint64_t hashes[BAYS], paused[2] = {0, 0};
			uint8_t mask[BAYS] = {0, 1, 0, 0, 0, 0, 0, 1}, pause[BAYS] = {1, 0, 0, 0, 1, 0, 0, 0, 0, 1};
			def.worlds = BAYS;
			def.templates = &level;
			def.template_count = 1;
			def.threads = 1;
			OK(scree_batch_create(&def, &batch));
			assert_int_equal(batch->block_count, 1);
			Form form = {.name = "bays",
			             .tiles = true,
			             .groups = 4,
			             .schedule = {.seed = 31u * (uint64_t)seed, .late = seed == 2}};
			form_take_backend(batch->blocks[0].backend, &form);
			scree_vec gravity[BAYS];
			for (int world = 0; world < BAYS; ++world)
				gravity[world] = (scree_vec){world % 2 ? 3.0f : 0.0f, world % 2 ? -25.0f : -10.0f};
			if (varied)
			{
				OK(scree_batch_set_gravity(batch, gravity));
				OK(scree_world_set_gravity(pulled, gravity[1]));
			}
			for (int k = 0; k < 40; ++k)
			{
				OK(scree_batch_step(batch, STEP, SUBSTEPS, 1));
				OK(scree_batch_get_hashes(batch, hashes));
				run_steps(level, 1);
				run_steps(pulled, 1);
				uint64_t now[2] = {hash_of(level), hash_of(varied ? pulled : level)};
				for (int world = 0; world < BAYS; ++world)
					if (hashes[world] != (pause[world] && k >= 30 ? paused : now)[world % 2] &&
					    !(mask[world] && k >= 20))
						fail_msg("joints %d, seed %d: world %d differs after step %d", joints, seed, world, k);
				if (k == 19)
					OK(scree_batch_reset(batch, mask));
				if (k != 29)
					continue;
				paused[0] = now[0];
				paused[1] = now[1];
				OK(scree_batch_pause(batch, pause));
			}
			assert_true(form_counts.bays == 3 && form_counts.solves >= 40);
			scree_batch_destroy(batch);
			scree_world_destroy(level);
			scree_world_destroy(pulled);
			form_close();
		}
}

static void bays_are_equal(void** state)
{
	(void)state;
	check_bays(false);
	check_bays(true);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(tiles_are_equal),
	    cmocka_unit_test(shunned_groups_are_found),
	    cmocka_unit_test(lost_words_are_found),
	    cmocka_unit_test(bays_are_equal),
	};
	int refused = check_refused();
	return refused ? refused : cmocka_run_group_tests(tests, NULL, NULL);
}
