// SPDX-License-Identifier: MIT
// test_batch_rows.c -- checks the states of single worlds of a batch as rows, also those of worlds that were taken out.
//
// Formula: hash(world loaded at age a, then stepped n times) = hash(same world alone, age a + n), for rows that go from
// any world to any other one of the same template, in batches of other sizes, threads, lanes and devices; for worlds
// that are taken out of a batch and step alone; and for worlds that are put back.
#include "support/batch_worlds.h"
#include "support/make_joints.h"

#define ROWS    24 // number of rows that are kept
#define BATCHES 3
#define MOST    12 // maximum number of worlds of a batch

typedef struct
{
	char* bytes;
	size_t size;
	int template, age; // template: -1 if empty
} Kept;

typedef struct // batches of the same templates
{
	Templates t;
	const char* name;
	scree_batch* batches[BATCHES];
	int template_of[BATCHES][MOST], ages[BATCHES][MOST], count;
	Kept kept[ROWS];
	scree_world* alone[2]; // worlds that were taken out
	int template[2], age[2];
} Exchange;

static void open_exchange(Exchange* x, const char* name)
{
	const Place places[] = {{"cpu", 6, 1, 0}, {"cpu", MOST, 2, 1}, {second_device, 4, 0, 0}};
	x->name = name;
	x->count = second_device[0] ? 3 : 2;
	for (int k = 0; k < x->count; ++k)
		x->batches[k] = open_batch(&x->t, places + k, x->template_of[k]);
	for (int k = 0; k < ROWS; ++k)
		x->kept[k].template = -1;
	record_alone(&x->t);
}

static void close_exchange(Exchange* x)
{
	for (int k = 0; k < x->count; ++k)
		scree_batch_destroy(x->batches[k]);
	for (int k = 0; k < ROWS; ++k)
		free(x->kept[k].bytes);
	for (int k = 0; k < 2; ++k)
		scree_world_destroy(x->alone[k]);
	close_templates(&x->t);
}

// Saves some worlds of batch b, in one call, into random places of the kept rows.
static void save_some(Exchange* x, int b)
{
	int worlds = scree_batch_get_worlds(x->batches[b]), count = 1 + random_below(4);
	size_t size = scree_batch_get_state_bytes(x->batches[b]) + 8 * (size_t)random_below(3);
	int32_t list[4];
	char* rows = malloc(size * (size_t)count);
	for (int k = 0; k < count; ++k)
		list[k] = random_below(worlds);
	OK(scree_batch_save(x->batches[b], list, count, rows, size));
	for (int k = 0; k < count; ++k)
	{
		Kept* kept = x->kept + random_below(ROWS);
		free(kept->bytes);
		*kept = (Kept){malloc(size), size, x->template_of[b][list[k]], x->ages[b][list[k]]};
		memcpy(kept->bytes, rows + size * (size_t)k, size);
	}
	free(rows);
}

static const Kept* find_kept(const Exchange* x, int template)
{
	for (int k = 0, n = random_below(ROWS); k < ROWS; ++k)
		if (x->kept[(n + k) % ROWS].template == template)
			return x->kept + (n + k) % ROWS;
	return NULL;
}

// Loads kept rows into some worlds of batch b: each into one, or one into all worlds of its template.
static void load_some(Exchange* x, int b)
{
	int worlds = scree_batch_get_worlds(x->batches[b]), count = 0;
	bool same = random_below(4) == 0;
	int32_t list[MOST];
	const Kept* rows[MOST];
	size_t size = 0;
	for (int w = 0; w < worlds; ++w)
	{
		const Kept* kept = same && count > 0 ? rows[0] : find_kept(x, x->template_of[b][w]);
		if (!kept || kept->template != x->template_of[b][w] || (!same && random_below(3) != 0))
			continue;
		rows[count] = kept;
		list[count++] = w;
		x->ages[b][w] = kept->age;
		size = kept->size > size ? kept->size : size;
	}
	char* bytes = calloc((size_t)count + 1, size + 1);
	for (int k = 0; k < count; ++k)
		memcpy(bytes + size * (size_t)k, rows[k]->bytes, rows[k]->size);
	OK(scree_batch_load(x->batches[b], list, count, bytes, same ? 0 : size));
	free(bytes);
}

static void check_alone(const Exchange* x, int k)
{
	uint64_t expected = x->t.hashes[x->template[k]][x->age[k]];
	if (hash_of(x->alone[k]) != expected)
		fail_msg("%s: world %d alone, template %d, age %d: hash %016llx, expected %016llx", x->name, k, x->template[k],
		         x -> age[k], (unsigned long long)hash_of(x->alone[k]), (unsigned long long)expected);
}

// Puts world k that is alone back into a batch, or takes one out.
static void exchange_alone(Exchange* x, int k)
{
	int b = random_below(x->count), w = random_below(scree_batch_get_worlds(x->batches[b]));
	scree_world_def def = scree_world_def_default();
	def.device = second_device[0] && random_below(8) == 0 ? second_device : "cpu";
	def.threads = 2;
	if (!x->alone[k])
	{
		OK(scree_batch_extract(x->batches[b], w, random_below(2) ? &def : NULL, x->alone + k));
		x->template[k] = x->template_of[b][w];
		x->age[k] = x->ages[b][w];
		check_alone(x, k);
	}
	else if (x->template_of[b][w] == x->template[k])
	{
		OK(scree_batch_insert(x->batches[b], w, x->alone[k]));
		x->ages[b][w] = x->age[k];
		check_alone(x, k);
		scree_world_destroy(x->alone[k]);
		x->alone[k] = NULL;
	}
}

static void step_batch(Exchange* x, int b)
{
	int worlds = scree_batch_get_worlds(x->batches[b]);
	uint8_t mask[MOST];
	for (int w = 0; w < worlds; ++w)
	{
		mask[w] = x->ages[b][w] == AGES || random_below(15) == 0;
		x->ages[b][w] = mask[w] ? 0 : x->ages[b][w];
	}
	OK(scree_batch_reset(x->batches[b], mask));
	save_some(x, b);
	load_some(x, b);
	for (int w = 0; w < worlds; ++w) // loaded rows may be the oldest
		mask[w] = x->ages[b][w] == AGES;
	OK(scree_batch_reset(x->batches[b], mask));
	for (int w = 0; w < worlds; ++w)
		x->ages[b][w] = mask[w] ? 0 : x->ages[b][w];
	if (random_below(3) == 0)
		check_hashes(x->batches[b], &x->t, x->template_of[b], x->ages[b], x->name);
	for (int w = 0; w < worlds; ++w) // states go to and from paused worlds too
		mask[w] = random_below(5) == 0;
	OK(scree_batch_pause(x->batches[b], mask));
	OK(scree_batch_step(x->batches[b], x->t.dt, x->t.substeps, 1));
	for (int w = 0; w < worlds; ++w)
		x->ages[b][w] += !mask[w];
	check_hashes(x->batches[b], &x->t, x->template_of[b], x->ages[b], x->name);
}

static void exchange_steps(Exchange* x, int steps)
{
	for (int step = 0; step < steps; ++step)
	{
		for (int b = 0; b < x->count; ++b)
			if (b < 2 || step % 3 == 0) // the second device needs more time
				step_batch(x, b);
		for (int k = 0; k < 2; ++k)
		{
			if (x->alone[k] && x->age[k] < AGES)
			{
				OK(scree_world_step(x->alone[k], x->t.dt, x->t.substeps));
				++x->age[k];
				check_alone(x, k);
			}
			if (random_below(3) == 0)
				exchange_alone(x, k);
		}
	}
}

static void scene_is_exchanged(const Scenario* scenario)
{
	for (int first = 0; first <= 25; first += 25)
	{
		Exchange x = {.t = {.dt = scenario->dt, .substeps = scenario->substeps}};
		random_state = (uint32_t)first + 11;
		open_scene_templates(&x.t, scenario, first);
		open_exchange(&x, scenario->name);
		exchange_steps(&x, quick() ? 12 : 36);
		close_exchange(&x);
	}
}

static void scenes_are_exchanged(void** state)
{
	(void)state;
	for_every_scene(scene_is_exchanged);
	player_close(small_players);
	player_close(small_players + 1);
	assert_int_equal(scree_memory(), 0);
}

// A ball that breaks a joint, a chain, and a platform that moves: joints break in the steps between saves.
static scree_world* breaking_world(float speed)
{
	scree_world* world = open_awake(-10.0f);
	scree_body bodies[12], platform;
	for (int k = 0; k < 12; ++k)
	{
		scree_body_def def = crate_def(world, SCREE_BODY_DYNAMIC, 1.1f * (float)k, 8.0f);
		OK(scree_body_create(world, &def, bodies + k));
		scree_joint_def joint = joint_def_at(world, SCREE_JOINT_REVOLUTE, k ? bodies[k - 1] : NOBODY, bodies[k],
		                                     1.1f * (float)k - 0.55f, 8.0f, 0.0f);
		joint.can_break = k % 3 == 2;
		joint.force_threshold = 30.0f + 10.0f * (float)k;
		add_joint(world, &joint);
	}
	scree_body_def def = crate_def(world, SCREE_BODY_KINEMATIC, 3.0f, 2.0f);
	def.velocity.linear.x = speed;
	def.velocity.angular = 1.0f;
	OK(scree_body_create(world, &def, &platform));
	def = crate_def(world, SCREE_BODY_STATIC, 3.0f, 0.0f);
	OK(scree_body_create(world, &def, &platform));
	return world;
}

static int broken_joints(scree_world* world)
{
	scree_joint joints[16];
	scree_joint_state states[16];
	int count, broken = 0;
	OK(scree_world_get_joints(world, joints, 16, &count));
	OK(scree_joints_get_states(world, joints, states, count));
	for (int k = 0; k < count; ++k)
		broken += states[k].broken;
	return broken;
}

static void broken_joints_stay_broken(void** state)
{
	(void)state;
	Exchange x = {.t = {.count = 2, .dt = STEP, .substeps = SUBSTEPS}};
	random_state = 3;
	x.t.worlds[0] = breaking_world(1.0f);
	x.t.worlds[1] = breaking_world(-2.0f);
	open_exchange(&x, "breaking");
	assert_true(broken_joints(x.t.worlds[0]) > 0);
	exchange_steps(&x, 150);
	close_exchange(&x);
	assert_int_equal(scree_memory(), 0);
}

// Resets of a world without hubs leave the list of the hubs of others alone. A world with a hub at rest is loaded too.
static scree_world* hub_world(int boxes)
{
	scree_world* world = open_awake(-10.0f);
	scree_body body;
	scree_body_def def = crate_def(world, SCREE_BODY_STATIC, 0.0f, -0.6f);
	OK(scree_body_create(world, &def, &body));
	scree_shape plank;
	OK(scree_shape_make_box(0.6f * (float)boxes, 0.2f, &plank));
	add_shape(world, SCREE_BODY_DYNAMIC, plank, 0.0f, 0.2f, 0.0f);
	for (int k = 0; k < boxes; ++k)
	{
		def = crate_def(world, SCREE_BODY_DYNAMIC, 1.1f * ((float)k - 0.5f * (float)(boxes - 1)), 0.9f);
		OK(scree_body_create(world, &def, &body));
	}
	for (int step = 0; step < 90; ++step)
		OK(scree_world_step(world, STEP, SUBSTEPS));
	return world;
}

static void hubs_are_kept(void** state)
{
	(void)state;
	Exchange x = {.t = {.count = 2, .dt = STEP, .substeps = SUBSTEPS}};
	random_state = 5;
	x.t.worlds[0] = hub_world(3);
	x.t.worlds[1] = hub_world(40);
	open_exchange(&x, "hubs");
	exchange_steps(&x, 60);
	close_exchange(&x);

	// only the world without hubs is reset
	Templates t = {.count = 2, .dt = STEP, .substeps = SUBSTEPS};
	t.worlds[0] = hub_world(3);
	t.worlds[1] = hub_world(40);
	scree_batch_def def = scree_batch_def_default();
	scree_batch* batch;
	def.worlds = 2;
	def.templates = t.worlds;
	def.template_count = 2;
	def.threads = 1;
	OK(scree_batch_create(&def, &batch));
	record_alone(&t);
	for (int age = 1; age <= AGES; ++age)
	{
		uint64_t hashes[2];
		OK(scree_batch_reset(batch, (const uint8_t[]){1, 0}));
		OK(scree_batch_step(batch, t.dt, t.substeps, 1));
		OK(scree_batch_get_hashes(batch, hashes));
		assert_true(hashes[0] == t.hashes[0][1] && hashes[1] == t.hashes[1][age]);
	}
	scree_batch_destroy(batch);
	close_templates(&t);
	assert_int_equal(scree_memory(), 0);
}

// Resets and loads between two steps take bounded memory: 300 of them as much as 20. Each load moves a hub, or makes
// contacts that the world before it lacked.
static void copies_take_bounded_memory(void** state)
{
	(void)state;
	for (int device = 0; device < 2 && (device == 0 || second_device[0]); ++device)
	{
		Templates t = {.count = 2, .dt = STEP, .substeps = SUBSTEPS};
		t.worlds[0] = hub_world(40);
		t.worlds[1] = falling_boxes(12);
		int template_of[6] = {0, 1, 0, 1, 0, 1}, ages[6] = {0};
		const int32_t falls[] = {1, 3, 5}, stands[] = {0, 2, 4};
		scree_batch_def def = scree_batch_def_default();
		scree_batch* batch;
		def.worlds = 6;
		def.templates = t.worlds;
		def.template_count = 2;
		def.template_of = template_of;
		def.threads = 1;
		def.device = device ? second_device : "cpu";
		OK(scree_batch_create(&def, &batch));
		record_alone(&t);
		OK(scree_batch_step(batch, t.dt, t.substeps, AGES / 2));
		size_t bytes = scree_batch_get_state_bytes(batch), memory = 0;
		char *fallen = malloc(bytes), *stood = malloc(bytes);
		OK(scree_batch_save(batch, falls, 1, fallen, bytes));
		OK(scree_batch_save(batch, stands, 1, stood, bytes));
		for (int k = 0; k < 300; ++k)
		{
			OK(scree_batch_reset(batch, k % 2 ? NULL : (const uint8_t[]){0, 1, 0, 1, 0, 1}));
			OK(scree_batch_load(batch, falls, 3, fallen, 0));
			if (k % 3 == 0)
				OK(scree_batch_load(batch, stands, 3, stood, 0));
			if (k == 20)
				memory = scree_memory();
		}
		assert_int_equal(scree_memory(), memory);
		for (int k = 0; k < 6; ++k)
			ages[k] = k % 2 ? AGES / 2 : 0;
		check_hashes(batch, &t, template_of, ages, "copies");
		for (int step = 0; step < 10; ++step)
		{
			OK(scree_batch_step(batch, t.dt, t.substeps, 1));
			for (int k = 0; k < 6; ++k)
				++ages[k];
			check_hashes(batch, &t, template_of, ages, "copies");
		}
		free(fallen);
		free(stood);
		scree_batch_destroy(batch);
		close_templates(&t);
	}
	assert_int_equal(scree_memory(), 0);
}

// Rows with more contacts than the bays have slots make the bays larger.
static void rows_may_have_more_contacts(void** state)
{
	(void)state;
	for (int device = 0; device < 2 && (device == 0 || second_device[0]); ++device)
	{
		Templates t = {.count = 1, .dt = STEP, .substeps = SUBSTEPS};
		int template_of[70], ages[70] = {0};
		t.worlds[0] = falling_boxes(24);
		Place place = {device ? second_device : "cpu", 70, 2, 0};
		scree_batch *batch = open_batch(&t, &place, template_of), *other = open_batch(&t, &place, template_of);
		record_alone(&t);
		size_t before = scree_batch_get_state_bytes(batch);
		OK(scree_batch_step(batch, t.dt, t.substeps, 30));
		size_t after = scree_batch_get_state_bytes(batch);
		assert_true(after > before);
		char* row = malloc(after);
		int32_t world = 69;
		OK(scree_batch_save(batch, &world, 1, row, after));
		for (world = 0; world < 70; world += 23)
		{
			OK(scree_batch_load(other, &world, 1, row, after));
			ages[world] = 30;
		}
		assert_true(scree_batch_get_state_bytes(other) > before);
		check_hashes(other, &t, template_of, ages, "growth");
		for (int step = 0; step < 10; ++step)
		{
			OK(scree_batch_step(other, t.dt, t.substeps, 1));
			for (int k = 0; k < 70; ++k)
				++ages[k];
			check_hashes(other, &t, template_of, ages, "growth");
		}
		free(row);
		scree_batch_destroy(batch);
		scree_batch_destroy(other);
		close_templates(&t);
	}
	assert_int_equal(scree_memory(), 0);
}

// Touches that an output saw before a load are not those of the loaded world.
static void touches_begin_after_a_load(void** state)
{
	(void)state;
	scree_world* world = falling_boxes(1);
	scree_body bodies[4];
	int count;
	OK(scree_world_get_bodies(world, bodies, 4, &count));
	scree_batch_def def = scree_batch_def_default();
	scree_batch* batch;
	def.templates = &world;
	def.template_count = 1;
	OK(scree_batch_create(&def, &batch));
	scree_channel touch = scree_channel_make(SCREE_OUTPUT_TOUCH);
	float touches[3];
	const int32_t only = 0;
	touch.body = bodies[count - 1];
	OK(scree_batch_bind(batch, SCREE_OUTPUTS, &touch, 1, touches));
	size_t size = scree_batch_get_state_bytes(batch);
	char *falls = malloc(size), *stands = malloc(2 * size);
	OK(scree_batch_save(batch, &only, 1, falls, size));
	OK(scree_batch_step(batch, STEP, SUBSTEPS, 100));
	assert_true(touches[0] > 0.0f);
	size_t grown = scree_batch_get_state_bytes(batch);
	assert_true(grown <= 2 * size);
	OK(scree_batch_save(batch, &only, 1, stands, grown));
	OK(scree_batch_load(batch, &only, 1, falls, size));
	OK(scree_batch_step(batch, STEP, SUBSTEPS, 1));
	assert_true(touches[0] == 0.0f);
	OK(scree_batch_load(batch, &only, 1, stands, grown));
	OK(scree_batch_step(batch, STEP, SUBSTEPS, 1));
	assert_true(touches[0] > 0.0f && touches[1] == 0.0f);
	free(falls);
	free(stands);
	scree_batch_destroy(batch);
	scree_world_destroy(world);
	assert_int_equal(scree_memory(), 0);
}

// Each damaged byte of a row is found, and nothing changes.
static void damaged_rows_are_refused(void** state)
{
	(void)state;
	scree_world* world = falling_boxes(2);
	scree_batch_def def = scree_batch_def_default();
	scree_batch* batch;
	uint64_t before[3], after[3];
	const int32_t first = 0, list[] = {1, 0, 2};
	def.worlds = 3;
	def.templates = &world;
	def.template_count = 1;
	def.threads = 1;
	OK(scree_batch_create(&def, &batch));
	OK(scree_batch_step(batch, STEP, SUBSTEPS, 40));
	size_t size = scree_batch_get_state_bytes(batch);
	char* rows = calloc(3, size);
	OK(scree_batch_save(batch, list, 3, rows, size));
	OK(scree_batch_step(batch, STEP, SUBSTEPS, 1));
	OK(scree_batch_get_hashes(batch, before));
	uint64_t used;
	memcpy(&used, rows + 32, sizeof used); // RowHead.bytes
	assert_true(used <= size);
	for (size_t k = 0; k < (size_t)used; ++k)
	{
		rows[size + k] ^= (char)(1 << k % 8);
		assert_int_equal(scree_batch_load(batch, list, 3, rows, size), SCREE_ERROR_INVALID);
		assert_non_null(strstr(scree_error(), "scree_batch_load: state 1 "));
		rows[size + k] ^= (char)(1 << k % 8);
	}
	OK(scree_batch_get_hashes(batch, after));
	assert_memory_equal(before, after, sizeof before);
	REFUSED(scree_batch_load(batch, &first, 1, rows, 16),
	        "scree_batch_load: state 0 has 16 bytes, fewer than its head of 176");
	assert_int_equal(scree_batch_load(batch, &first, 1, rows, (size_t)used - 1), SCREE_ERROR_INVALID);
	OK(scree_batch_load(batch, &first, 1, rows, (size_t)used));
	OK(scree_batch_load(batch, list, 3, rows, size));
	free(rows);
	scree_batch_destroy(batch);
	scree_world_destroy(world);
	assert_int_equal(scree_memory(), 0);
}

static void bad_arguments_are_refused(void** state)
{
	(void)state;
	scree_world *world = falling_boxes(2), *more = falling_boxes(3), *light = open_awake(-5.0f), *made = world;
	scree_batch_def def = scree_batch_def_default();
	scree_batch *batch, *other;
	const int32_t twice[] = {1, 2, 1}, beyond[] = {0, 3};
	def.worlds = 3;
	def.templates = &world;
	def.template_count = 1;
	OK(scree_batch_create(&def, &batch));
	def.templates = &more;
	OK(scree_batch_create(&def, &other));
	size_t size = scree_batch_get_state_bytes(batch);
	char *rows = calloc(3, size), sentence[128];
	assert_int_equal(scree_batch_get_state_bytes(NULL), 0);
	REFUSED(scree_batch_save(NULL, twice, 1, rows, size), "scree_batch_save: batch is null");
	REFUSED(scree_batch_save(batch, NULL, 1, rows, size), "scree_batch_save: worlds is null");
	REFUSED(scree_batch_save(batch, twice, 1, NULL, size), "scree_batch_save: states is null");
	REFUSED(scree_batch_save(batch, twice, -1, rows, size), "scree_batch_save: count is -1, must be at least 0");
	REFUSED(scree_batch_save(batch, beyond, 2, rows, size), "scree_batch_save: worlds[1] is 3, must be from 0 to 2");
	snprintf(sentence, sizeof sentence,
	         "scree_batch_save: state_bytes is %zu, must be at least %zu (scree_batch_get_state_bytes)", size - 1,
	         size);
	REFUSED(scree_batch_save(batch, twice, 1, rows, size - 1), sentence);
	OK(scree_batch_save(batch, NULL, 0, NULL, 0));
	OK(scree_batch_load(batch, NULL, 0, NULL, 0));
	REFUSED(scree_batch_load(batch, twice, 1, rows, size),
	        "scree_batch_load: state 0 does not come from scree_batch_save");
	OK(scree_batch_save(batch, twice, 3, rows, size));
	REFUSED(scree_batch_load(batch, twice, 3, rows, size), "scree_batch_load: worlds[2] is 1, as is worlds[0]");
	REFUSED(scree_batch_load(batch, beyond, 2, rows, size), "scree_batch_load: worlds[1] is 3, must be from 0 to 2");
	REFUSED(scree_batch_load(batch, twice, 1, NULL, size), "scree_batch_load: states is null");
	REFUSED(
	    scree_batch_load(other, twice, 1, rows, size),
	    "scree_batch_load: state 0 is that of a world with another structure or other settings than the template of "
	    "world 1");
	REFUSED(scree_batch_extract(batch, 3, NULL, &made), "scree_batch_extract: world is 3, must be from 0 to 2");
	assert_null(made);
	REFUSED(scree_batch_extract(batch, 0, NULL, NULL), "scree_batch_extract: made is null");
	REFUSED(scree_batch_insert(batch, -1, world), "scree_batch_insert: world is -1, must be from 0 to 2");
	assert_int_equal(scree_batch_insert(batch, 0, NULL), SCREE_ERROR_INVALID);
	REFUSED(
	    scree_batch_insert(batch, 0, more),
	    "scree_batch_insert: from has 5 bodies, 4 collidables and 0 joints, but the template of world 0 has 4, 3 and "
	    "0");
	OK(scree_batch_insert(batch, 0, world));
	OK(scree_world_set_gravity(world, (scree_vec){0.0f, -5.0f})); // not a part of the state
	OK(scree_batch_insert(batch, 0, world));
	scree_tuning tuning;
	OK(scree_world_get_tuning(world, &tuning));
	tuning.contact_hertz = 20.0f;
	OK(scree_world_set_tuning(world, &tuning));
	REFUSED(scree_batch_insert(batch, 0, world), "scree_batch_insert: from has other settings, or other shapes, "
	                                             "densities, joints or rules, than the template of "
	                                             "world 0");
	scree_world* sleeper = open_world(-10.0f);
	REFUSED(scree_batch_insert(batch, 0, sleeper), "scree_batch_insert: from has 1 bodies, 0 collidables and 0 joints, "
	                                               "but the template of world 0 has 4, 3 and 0");
	free(rows);
	scree_batch_destroy(batch);
	scree_batch_destroy(other);
	scree_world_destroy(world);
	scree_world_destroy(more);
	scree_world_destroy(light);
	scree_world_destroy(sleeper);
	assert_int_equal(scree_memory(), 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(bad_arguments_are_refused),  cmocka_unit_test(damaged_rows_are_refused),
	    cmocka_unit_test(touches_begin_after_a_load), cmocka_unit_test(rows_may_have_more_contacts),
	    cmocka_unit_test(copies_take_bounded_memory), cmocka_unit_test(hubs_are_kept),
	    cmocka_unit_test(broken_joints_stay_broken),  cmocka_unit_test(scenes_are_exchanged),
	};
	return cmocka_run_group_tests(tests, find_second_device, NULL);
}
