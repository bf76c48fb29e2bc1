// SPDX-License-Identifier: MIT
// test_batch_pause.c -- checks paused worlds of a batch, worlds with too many contacts, and counters of worlds.
//
// Formula: hash and counters (world in a batch) = hash and counters (same world alone after as many steps), with pauses and
// resets at random. A paused world takes no steps. Nor does a world whose contacts are more than the limit: it stays as it
// is after the last step that the same world alone, with this limit, does not refuse.
#include "support/batch_checks.h"
#include "support/make_joints.h"
#include "support/second_device.h"
#include "support/small_scenes.h"

#define MOST_TEMPLATES 16
#define MOST_WORLDS    96
#define AGES           30 // number of steps of a template that are recorded

typedef struct // a world alone after a number of steps
{
	uint64_t hash;
	scree_counters counters;
} Alone;

typedef struct
{
	scree_world* worlds[MOST_TEMPLATES];
	Alone alone[MOST_TEMPLATES][AGES + 1];
	int ends[MOST_TEMPLATES]; // number of steps before the first one that is refused; AGES if none is
	int crowded
	    [MOST_TEMPLATES]; // number of contacts of the step that is refused, at least: a world alone does not find all
	int count;
	float dt;
	int substeps;
} Templates;

typedef struct
{
	const char* device;
	int worlds, threads, lanes, contact_limit;
} Place;

typedef struct // a batch and what it must contain
{
	scree_batch* batch;
	const Templates* templates;
	const char* name;
	int worlds;
	int template_of[MOST_WORLDS], ages[MOST_WORLDS];
	uint8_t paused[MOST_WORLDS];
	bool crowded[MOST_WORLDS]; // paused because of its contacts
} Checked;

static void record_alone(Templates* t)
{
	for (int k = 0; k < t->count; ++k)
	{
		t->ends[k] = AGES;
		for (int age = 0; age <= t->ends[k]; ++age)
		{
			Alone* alone = &t->alone[k][age];
			alone->hash = hash_of(t->worlds[k]);
			OK(scree_world_get_counters(t->worlds[k], &alone->counters));
			scree_status status = scree_world_step(t->worlds[k], t->dt, t->substeps);
			int contacts, pairs;
			if (status == SCREE_OK)
				continue;
			assert_int_equal(status, SCREE_ERROR_CONTACT_LIMIT);
			if (sscanf(scree_error(), "scree_world_step: %d contacts and at least %d", &contacts, &pairs) != 2)
				assert_int_equal(sscanf(scree_error(), "scree_world_step: %d contacts and %d", &contacts, &pairs), 2);
			t->crowded[k] = contacts + pairs;
			t->ends[k] = age;
		}
	}
}

static void close_templates(Templates* t)
{
	for (int k = 0; k < t->count; ++k)
		scree_world_destroy(t->worlds[k]);
	t->count = 0;
}

static scree_status try_batch(Templates* t, const Place* place, Checked* c)
{
	scree_batch_def def = scree_batch_def_default();
	*c = (Checked){.templates = t, .worlds = place->worlds};
	def.worlds = place->worlds;
	def.templates = t->worlds;
	def.template_count = t->count;
	def.template_of = c->template_of;
	def.device = place->device;
	def.threads = place->threads;
	def.lanes = lanes_here(place->lanes);
	def.contact_limit = place->contact_limit;
	for (int k = 0; k < def.worlds; ++k)
		c->template_of[k] = random_below(t->count);
	return scree_batch_create(&def, &c->batch);
}

static void check_counters(const Checked* c, int world, const scree_batch_counters* now)
{
	const Templates* t = c->templates;
	const scree_counters* alone = &t->alone[c->template_of[world]][c->ages[world]].counters;
	int crowded = c->crowded[world] ? t->crowded[c->template_of[world]] : 0;
	if (now->contacts != alone->contacts || now->touching != alone->touching ||
	    now->penetration != alone->penetration || now->joint_gap != alone->joint_gap ||
	    now->frozen_bodies != alone->frozen_bodies || now->asleep_bodies != alone->asleep_bodies ||
	    now->crowded < crowded || (now->crowded > 0) != c->crowded[world])
		fail_msg(
		    "%s: world %d, template %d, age %d, paused %d: contacts %d %d, touching %d %d, penetration %g %g, gap %g "
		    "%g, frozen %d %d, asleep %d %d, crowded %d %d",
		    c->name, world, c->template_of[world], c->ages[world], c->paused[world], now->contacts, alone->contacts,
		    now->touching, alone->touching, (double)now->penetration, (double)alone->penetration,
		    (double)now->joint_gap, (double)alone->joint_gap, now->frozen_bodies, alone->frozen_bodies,
		    now->asleep_bodies, alone->asleep_bodies, now->crowded, crowded);
}

static void check(const Checked* c)
{
	uint64_t hashes[MOST_WORLDS];
	scree_batch_counters counters[MOST_WORLDS];
	OK(scree_batch_get_hashes(c->batch, hashes));
	OK(scree_batch_get_counters(c->batch, counters));
	for (int k = 0; k < c->worlds; ++k)
	{
		uint64_t alone = c->templates->alone[c->template_of[k]][c->ages[k]].hash;
		if (hashes[k] != alone)
			fail_msg("%s: world %d of %d, template %d, age %d, paused %d: hash %016llx, alone %016llx", c->name, k,
			         c->worlds, c->template_of[k], c->ages[k], c->paused[k], (unsigned long long)hashes[k],
			         (unsigned long long)alone);
		check_counters(c, k, counters + k);
	}
}

static void pause_some(Checked* c)
{
	static const int shares[] = {0, 5, 50, 90, 100};
	int share = shares[random_below(5)];
	for (int k = 0; k < c->worlds; ++k)
	{
		c->paused[k] = random_below(100) < share;
		c->crowded[k] &= c->paused[k]; // a crowded world that stays paused keeps its number
	}
	OK(scree_batch_pause(c->batch, share == 0 ? NULL : c->paused));
}

// Puts worlds back to their templates: those at the end of the record, and others at random.
static void reset_some(Checked* c, int share)
{
	uint8_t mask[MOST_WORLDS];
	int resets = 0;
	for (int k = 0; k < c->worlds; ++k)
	{
		mask[k] = (c->ages[k] == AGES && !c->paused[k]) || random_below(100) < share;
		resets += mask[k];
		if (!mask[k])
			continue;
		c->ages[k] = 0;
		c->paused[k] = 0;
		c->crowded[k] = false;
	}
	if (resets > 0)
		OK(scree_batch_reset(c->batch, mask));
}

static void step_once(Checked* c)
{
	OK(scree_batch_step(c->batch, c->templates->dt, c->templates->substeps, 1));
	for (int k = 0; k < c->worlds; ++k)
	{
		if (c->paused[k])
			continue;
		c->crowded[k] = c->ages[k] == c->templates->ends[c->template_of[k]] && c->ages[k] < AGES;
		c->paused[k] = c->crowded[k];
		c->ages[k] += !c->crowded[k];
	}
}

// Steps a batch with random masks, and compares all worlds with their templates, which record_alone has stepped.
static void check_batch(Checked* c, int steps, const char* name)
{
	c->name = name;
	check(c);
	for (int step = 0; step < steps; ++step)
	{
		if (random_below(3) == 0)
			pause_some(c);
		reset_some(c, random_below(4) == 0 ? 20 : 0);
		if (random_below(3) == 0)
			pause_some(c);
		reset_some(c, 0); // worlds that run again at the end of the record
		if (step % 4 == 0)
			check(c);
		step_once(c);
		if (step % 4 < 2)
			check(c);
	}
	OK(scree_batch_pause(c->batch, NULL));
	memset(c->paused, 0, sizeof c->paused);
	memset(c->crowded, 0, sizeof c->crowded);
	check(c);
	scree_batch_destroy(c->batch);
}

// Removes the last template if the batch refuses it.
static bool templates_fit(Templates* t)
{
	Checked tried;
	if (try_batch(t, &(Place){"cpu", 1, 1, 1, 0}, &tried) == SCREE_OK)
	{
		scree_batch_destroy(tried.batch);
		return true;
	}
	scree_world_destroy(t->worlds[--t->count]);
	return false;
}

static void scene_equals(const Scenario* scenario)
{
	Templates t = {.dt = scenario->dt, .substeps = scenario->substeps};
	Checked c;
	for (int first = 0; first <= 25; first += 25) // with joints that have not begun; in motion
	{
		for (int k = 0; k < 2; ++k)
		{
			t.worlds[t.count++] = scene_world(scenario, first == 0 ? 0 : first + 9 * k);
			if (!templates_fit(&t))
				break; // a second template with paths, or any with fields
		}
		if (t.count == 0)
			return;
		random_state = (uint32_t)first + 3;
		OK(try_batch(&t, &(Place){"cpu", 7, 1, 0, 0}, &c));
		record_alone(&t);
		check_batch(&c, quick() ? 12 : 40, scenario->name);
		close_templates(&t);
	}
}

// Worlds of each scene: with hubs, kinematic bodies, joints that break, paths, pairs of materials.
static void scenes_are_paused(void** state)
{
	(void)state;
	for_every_scene(scene_equals);
	player_close(small_players);
	player_close(small_players + 1);
	assert_int_equal(scree_memory(), 0);
}

// Worlds of different scenes in one batch change their bays, which then get other chains and other pairs that never touch.
static void templates_are_mixed(void** state)
{
	static const char* const names[] = {"bridge",   "cars",    "chains", "dominoes", "gears",    "machine",
	                                    "ragdolls", "tumbler", "washer", "windmill", "pyramids", "alarm-clock"};
	(void)state;
	Templates t = {.dt = STEP, .substeps = SUBSTEPS};
	Scenario scenarios[MOST_TEMPLATES];
	int opened = 0;
	for (size_t k = 0; k < sizeof names / sizeof *names; ++k)
	{
		scenarios[opened] = small_scene(names[k]);
		t.worlds[t.count++] = scene_world(scenarios + opened++, 20);
		templates_fit(&t); // not with another gravity, or another length of a substep
	}
	assert_true(t.count >= 8);
	const Place places[] = {{"cpu", 41, 1, 0, 0}, {"cpu", 90, 2, 4, 0}, {second_device, 30, 0, 0, 0}};
	Checked batches[3];
	for (int k = 0; k < 3; ++k)
		if (places[k].device[0])
			OK(try_batch(&t, places + k, batches + k));
	record_alone(&t);
	for (int k = 0; k < 3; ++k)
		if (places[k].device[0])
			check_batch(batches + k, k == 2 || quick() ? 16 : 60, "mixed");
	close_templates(&t);
	for (int k = 0; k < opened; ++k)
		scene_free((Scene*)scenarios[k].context);
	player_close(small_players);
	player_close(small_players + 1);
	assert_int_equal(scree_memory(), 0);
}

// Opens a world of boxes that fall on one another, so that contacts become more from step to step.
static scree_world* falling_boxes(int boxes, int contact_limit)
{
	scree_world_def def = scree_world_def_default();
	def.device = "cpu";
	def.threads = 1;
	def.sleep = false;
	def.contact_limit = contact_limit;
	scree_world* world = create_world(&def);
	scree_body_def body = crate_def(world, SCREE_BODY_STATIC, 0.0f, -1.0f);
	scree_body made;
	OK(scree_body_create(world, &body, &made));
	for (int k = 0; k < boxes; ++k)
	{
		body = crate_def(world, SCREE_BODY_DYNAMIC, 0.3f * (float)(k % 3), 0.5f + 1.02f * (float)k);
		OK(scree_body_create(world, &body, &made));
	}
	return world;
}

// Worlds with more contacts than the limit are left as they were, and the others go on. A limit may be below the number of
// slots of a bay.
static void crowded_worlds_stay(void** state)
{
	static const int limits[] = {5, 12, 16, 23};
	(void)state;
	for (size_t n = 0; n < sizeof limits / sizeof *limits; ++n)
		for (int device = 0; device < (second_device[0] && n % 2 == 0 ? 3 : 2); ++device)
		{
			Templates t = {.dt = STEP, .substeps = SUBSTEPS};
			static const int boxes[] = {24, 3, 12, 1, 18};
			for (size_t k = 0; k < sizeof boxes / sizeof *boxes; ++k)
				t.worlds[t.count++] = falling_boxes(boxes[k], limits[n]);
			Place place = {device == 2 ? second_device : "cpu", device == 0 ? 5 : 70, 1 + device, 0, limits[n]};
			Checked c;
			OK(try_batch(&t, &place, &c));
			record_alone(&t);
			assert_int_equal(t.ends[3], AGES);
			assert_true(t.ends[0] < AGES);
			check_batch(&c, device == 2 ? 24 : 60, "crowded");
			close_templates(&t);
		}
	assert_int_equal(scree_memory(), 0);
}

static void bad_arguments_are_refused(void** state)
{
	(void)state;
	scree_world* world = falling_boxes(3, 0);
	scree_batch_def def = scree_batch_def_default();
	scree_batch* batch;
	scree_batch_counters counters[2];
	const uint8_t mask[2] = {1, 0};
	def.worlds = 2;
	def.templates = &world;
	def.template_count = 1;
	def.contact_limit = -1;
	REFUSED(scree_batch_create(&def, &batch), "scree_batch_create: def.contact_limit is -1, must be from 0 to 4096");
	def.contact_limit = 4097;
	REFUSED(scree_batch_create(&def, &batch), "scree_batch_create: def.contact_limit is 4097, must be from 0 to 4096");
	for (int step = 0; step < AGES; ++step)
		OK(scree_world_step(world, STEP, SUBSTEPS));
	def.contact_limit = 1;
	REFUSED(scree_batch_create(&def, &batch),
	        "scree_batch_create: template 0 has 3 contacts, more than def.contact_limit, 1");
	def.contact_limit = 0;
	OK(scree_batch_create(&def, &batch));
	REFUSED(scree_batch_pause(NULL, mask), "scree_batch_pause: batch is null");
	REFUSED(scree_batch_get_counters(NULL, counters), "scree_batch_get_counters: batch is null");
	REFUSED(scree_batch_get_counters(batch, NULL), "scree_batch_get_counters: counters is null");
	OK(scree_batch_pause(batch, mask));
	OK(scree_batch_step(batch, STEP, SUBSTEPS, 1));
	scree_batch_destroy(batch);
	scree_world_destroy(world);
	assert_int_equal(scree_memory(), 0);
}

// Joints of a paused world scale their impulses by the length of the world's own last substep.
static void lengths_may_differ(void** state)
{
	(void)state;
	Scenario scenario = small_scene("ragdolls");
	scree_world *world = scene_world(&scenario, 15), *paused = scene_world(&scenario, 15);
	scree_batch_def def = scree_batch_def_default();
	scree_batch* batch;
	const uint8_t mask[3] = {0, 1, 0}, all[3] = {1, 1, 1};
	static const int factors[] = {1, 2, 2, 3, 1, 2};
	uint64_t hashes[3];
	def.worlds = 3;
	def.templates = &world;
	def.template_count = 1;
	OK(scree_batch_create(&def, &batch));
	for (int k = 0; k < 6; ++k)
	{
		bool rests = k == 1 || k == 2;
		int substeps = factors[k] * scenario.substeps;
		if (k == 4)
		{
			OK(scree_batch_pause(batch, all));
			OK(scree_batch_step(batch, scenario.dt, 5 * substeps, 1)); // no world runs
		}
		OK(scree_batch_pause(batch, rests ? mask : NULL));
		OK(scree_batch_step(batch, scenario.dt, substeps, 1));
		OK(scree_world_step(world, scenario.dt, substeps));
		if (!rests)
			OK(scree_world_step(paused, scenario.dt, substeps));
		OK(scree_batch_get_hashes(batch, hashes));
		for (int w = 0; w < 3; ++w)
			if (hashes[w] != hash_of(w == 1 ? paused : world))
				fail_msg("world %d differs after step %d", w, k);
	}
	scree_batch_destroy(batch);
	scree_world_destroy(world);
	scree_world_destroy(paused);
	scene_free((Scene*)scenario.context);
	player_close(small_players);
	player_close(small_players + 1);
	assert_int_equal(scree_memory(), 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(scenes_are_paused),   cmocka_unit_test(templates_are_mixed),
	    cmocka_unit_test(crowded_worlds_stay), cmocka_unit_test(bad_arguments_are_refused),
	    cmocka_unit_test(lengths_may_differ),
	};
	return cmocka_run_group_tests(tests, find_second_device, NULL);
}
