// SPDX-License-Identifier: MIT
// test_draw_worlds.c -- checks that a drawing is the same on every device, changes nothing, and contains exactly the things in
// its box; and the list of collidables with poses and shapes.
#include "support/draw_log.h"
#include "support/make_fields.h"
#include "support/make_paths.h"
#include "support/scenarios.h"
#include "tools/common/byte_hash.h"
#include "tools/common/clock.h"
#include "tools/common/random_numbers.h"
#include "world/upload/upload.h"
#include "world/world.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define ALL (2 * SCREE_DRAW_LABELS - 1)

static DrawLog drawing, whole;

static scree_shape any_shape(uint64_t* seed)
{
	scree_vec corners[3] = {{-0.5f, -0.4f}, {0.6f, -0.3f}, {0.0f, 0.6f}};
	switch (random_below(seed, 4))
	{
	case 0:
		return circle_shape(0.4f);
	case 1:
		return capsule_shape(0.4f, 0.2f);
	case 2:
		return polygon_shape(corners, 3, 0.1f);
	default:
		return box_shape(0.5f, 0.3f);
	}
}

// Fills a world with bodies of all types and shapes, among them sensors and disabled ones, with joints and fields.
static void fill(scree_world* world)
{
	uint64_t seed = 5;
	add_floor(world);
	for (int k = 0; k < 60; ++k)
	{
		float x = random_between(&seed, -6.0f, 6.0f), y = random_between(&seed, 1.0f, 12.0f);
		scree_body_type type = k % 10 == 0 ? SCREE_BODY_KINEMATIC : SCREE_BODY_DYNAMIC;
		scree_body_def def = body_def(type, shape_attribute(world, any_shape(&seed)), x, y);
		def.pose.rotation = scree_rot_make(random_between(&seed, -3.0f, 3.0f));
		def.sensor = k % 13 == 0 ? SCREE_SENSOR_MOVING : 0;
		def.disabled = k % 11 == 5;
		scree_body body = create_body(world, &def), ground = {0, 0};
		if (k % 7 == 0)
			join(world, k % 2 ? SCREE_JOINT_REVOLUTE : SCREE_JOINT_PRISMATIC, ground, body, x + 0.5f, y + 1.0f);
	}
	scree_collidable_def zone = scree_collidable_def_default();
	zone.attribute = box_attribute(world, 2.0f, 1.0f);
	zone.pose.position.y = 3.0f;
	create_collidable(world, &zone);
	scree_field_def wind = scree_field_def_default(SCREE_FIELD_WIND);
	wind.shape = box_shape(3.0f, 3.0f);
	wind.velocity.x = 2.0f;
	add_field(world, &wind);
	ride(world, add_circle(world, 4.0, 0.0, 5.0, 12), add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 1.0f), false);
}

// Draws all things after each of some steps. Fails if the world differs from one that was not drawn. Returns the hash of
// all drawings.
static uint64_t draw_steps(const Variant* variant)
{
	scree_world *world = open_default_variant(variant), *twin = open_default_variant(variant);
	uint64_t hash = HASH_BEGIN;
	fill(world);
	fill(twin);
	for (int k = 0; k < 60; ++k)
	{
		OK(scree_world_step(world, STEP, SUBSTEPS));
		OK(scree_world_step(twin, STEP, SUBSTEPS));
		if (k % 6 != 0)
			continue;
		draw_into(&drawing, world, ALL, NULL);
		assert_true(drawing.counts[DRAWN_POLYGON] > 20 && drawing.counts[DRAWN_CIRCLE] > 5);
		hash = hash_bytes(hash, &drawing.hash, sizeof drawing.hash);
		assert_true(hash_of(world) == hash_of(twin));
	}
	scree_world_destroy(twin);
	scree_world_destroy(world);
	return hash;
}

// Formula: drawing(device, lanes, threads, step) = drawing(cpu, 1, 1, step), and world hashes with and without drawing are
// equal.
static void drawings_are_equal_on_all_devices(void** state)
{
	(void)state;
	check_equal(draw_steps);
}

// Returns the hash of the entries of a drawing whose bounding boxes overlap a box.
static uint64_t hash_inside(const DrawLog* log, scree_box view, int* count)
{
	uint64_t hash = HASH_BEGIN;
	*count = 0;
	assert_true(log->total <= MOST_STORED);
	for (int k = 0; k < log->total; ++k)
	{
		const Drawn* d = log->entries + k;
		float by = d->kind == DRAWN_POINT ? 0.0f : d->size;
		scree_box box = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
		for (int i = 0; i < d->count; ++i)
		{
			box.lower.x = fminf(box.lower.x, d->points[i].x - by);
			box.lower.y = fminf(box.lower.y, d->points[i].y - by);
			box.upper.x = fmaxf(box.upper.x, d->points[i].x + by);
			box.upper.y = fmaxf(box.upper.y, d->points[i].y + by);
		}
		if (box.lower.x > view.upper.x || box.upper.x < view.lower.x || box.lower.y > view.upper.y ||
		    box.upper.y < view.lower.y)
			continue;
		hash = hash_bytes(hash, d, sizeof *d);
		++*count;
	}
	return hash;
}

// A drawing of a box has exactly those entries of the whole drawing whose bounding boxes overlap the box, in this order.
static void culling_is_exact(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	uint64_t seed = 9;
	int count, seen = 0;
	fill(world);
	run_steps(world, 40);
	draw_into(&whole, world, ALL, NULL);
	for (int k = 0; k < 50; ++k)
	{
		scree_box view = {{random_between(&seed, -9.0f, 9.0f), random_between(&seed, -1.0f, 9.0f)}, {0, 0}};
		float size = k % 5 == 0 ? 0.0f : random_between(&seed, 0.0f, 4.0f);
		view.upper = (scree_vec){view.lower.x + size, view.lower.y + size};
		draw_into(&drawing, world, ALL, &view);
		uint64_t hash = hash_inside(&whole, view, &count);
		assert_int_equal(drawing.total, count);
		assert_true(drawing.hash == hash);
		seen += count;
	}
	assert_true(seen > 500);
	scree_box everywhere = {{-INFINITY, -INFINITY}, {INFINITY, INFINITY}};
	draw_into(&drawing, world, ALL, &everywhere);
	assert_true(drawing.hash == whole.hash && drawing.total == whole.total);
	scree_box far = {{90000.0f, 90000.0f}, {90001.0f, 90001.0f}};
	draw_into(&drawing, world, ALL, &far);
	assert_int_equal(drawing.total, 0);
	scree_world_destroy(world);
}

// The poses have the bits of render rows; a disabled collidable has the pose that its row had before.
static void states_are_those_of_render_rows(void** state)
{
	(void)state;
	scree_world* world = open_test_world(-10.0f);
	fill(world);
	run_steps(world, 30);
	static scree_render_row rows[100];
	static scree_collidable_state states[100], few[3];
	int row_count, count, listed;
	OK(scree_world_get_render_rows(world, rows, 100, &row_count));
	OK(scree_world_get_collidable_states(world, NULL, states, 100, &count));
	assert_int_equal(count, counters_of(world).collidables);
	for (int k = 0; k < count; ++k)
	{
		const scree_collidable_state* s = states + k;
		const scree_render_row* row = rows + (s->collidable.index - 1);
		assert_true(scree_collidable_is_valid(world, s->collidable));
		assert_true(k == 0 || s->collidable.index > states[k - 1].collidable.index);
		scree_body body;
		scree_attribute attribute;
		scree_attribute_def def;
		OK(scree_collidable_get_body(world, s->collidable, &body));
		OK(scree_collidable_get_attribute(world, s->collidable, &attribute));
		OK(scree_attribute_get_def(world, attribute, &def));
		assert_true(scree_body_equals(body, s->body) && scree_attribute_equals(attribute, s->attribute));
		assert_memory_equal(s->shape, &def.shape, sizeof def.shape);
		assert_true(s->disabled == (row->attribute < 0));
		assert_true(s->disabled || memcmp(&s->pose, &row->pose, sizeof s->pose) == 0);
	}
	OK(scree_world_get_collidable_states(world, NULL, few, 3, &listed));
	assert_int_equal(listed, count);
	assert_memory_equal(few, states, sizeof few);
	OK(scree_world_get_collidable_states(world, NULL, NULL, 0, &listed));
	assert_int_equal(listed, count);
	scree_box corner = {{-0.1f, -0.1f}, {0.0f, -0.05f}};
	OK(scree_world_get_collidable_states(world, &corner, states, 100, &listed));
	assert_true(listed >= 1 && listed < count && states[0].type == SCREE_BODY_STATIC);

	scree_body crate = add_crate(world, SCREE_BODY_DYNAMIC, 30.0f, 5.0f);
	scree_box around = {{29.0f, 4.0f}, {31.0f, 6.0f}};
	OK(scree_body_set_pose(world, crate, pose_at(30.0f, 5.0f, 1.0f)));
	OK(scree_world_get_collidable_states(world, &around, few, 3, &listed));
	assert_int_equal(listed, 1);
	OK(scree_body_set_enabled(world, crate, false));
	OK(scree_world_get_collidable_states(world, &around, few + 1, 1, &listed));
	assert_true(listed == 1 && few[1].disabled && !few[0].disabled);
	assert_memory_equal(&few[0].pose, &few[1].pose, sizeof few[0].pose);
	scree_world_destroy(world);
}

// Overwrites the velocity of a body in its pool by NaN. The body is frozen in the next step, and has its color until then.
static void frozen_bodies_are_red(void** state)
{
	(void)state;
	scree_world* world = open_test_world(0.0f);
	add_crate(world, SCREE_BODY_DYNAMIC, 0.0f, 0.0f);
	scree_body victim = add_crate(world, SCREE_BODY_DYNAMIC, 5.0f, 0.0f);
	run_steps(world, 1);
	Backend* b = world->backend;
	BodyState row;
	OK(world_upload(world));
	OK(b->f->read(b, POOL_body, (int)victim.index, 1, &row));
	row.vx = NAN;
	OK(b->f->write(b, POOL_body, (int)victim.index, 1, &row));
	run_steps(world, 1);
	draw_into(&drawing, world, SCREE_DRAW_SHAPES, NULL);
	assert_int_equal(count_drawn(&drawing, DRAWN_POLYGON, SCREE_COLOR_DYNAMIC), 1);
	const Drawn* frozen = drawn_at(&drawing, DRAWN_POLYGON, SCREE_COLOR_FROZEN, 0);
	NEAR((frozen->points[0].x + frozen->points[2].x) / 2, 5.0, 1e-5);
	run_steps(world, 1);
	draw_into(&drawing, world, SCREE_DRAW_SHAPES, NULL);
	assert_int_equal(count_drawn(&drawing, DRAWN_POLYGON, SCREE_COLOR_DYNAMIC), 2);
	scree_world_destroy(world);
}

// Draws a box ten times, and prints the median time of a call.
static void draw_timed(scree_world* world, const char* name, uint32_t flags, const scree_box* box)
{
	double times[10];
	for (int k = 0; k < 10; ++k)
	{
		double begin = seconds_now();
		scree_draw_def def = log_def(&drawing, flags);
		drawing.brief = true;
		OK(scree_world_draw(world, &def, box));
		times[k] = seconds_now() - begin;
		for (int i = k; i > 0 && times[i] < times[i - 1]; --i)
		{
			double swap = times[i];
			times[i] = times[i - 1];
			times[i - 1] = swap;
		}
	}
	print_message("20,000 bodies, %s: %d entries, %.2f ms\n", name, drawing.total, 1e3 * times[5]);
}

// A view of some of 20,000 bodies costs the reading of the arrays, and not the drawing of the others.
static void many_bodies_are_culled(void** state)
{
	(void)state;
	int count = quick() ? 2000 : 20000;
	scree_world* world = open_test_world(-10.0f);
	scree_attribute crate = box_attribute(world, 0.5f, 0.5f);
	scree_body_def* defs = malloc((size_t)count * sizeof *defs);
	assert_non_null(defs);
	add_floor(world);
	for (int k = 0; k < count; ++k)
		defs[k] = body_def(SCREE_BODY_DYNAMIC, crate, 1.2f * (float)(k % 150) - 90.0f, 0.5f + 1.01f * (float)(k / 150));
	OK(scree_bodies_create(world, defs, count, NULL));
	free(defs);
	run_steps(world, 2);
	scree_box view = {{-5.0f, 0.0f}, {5.0f, 5.0f}};
	uint32_t usual = SCREE_DRAW_SHAPES | SCREE_DRAW_SENSORS | SCREE_DRAW_JOINTS;
	draw_timed(world, "shapes", usual, NULL);
	assert_int_equal(drawing.counts[DRAWN_POLYGON], count + 1);
	draw_timed(world, "shapes in a box of 10 m", usual, &view);
	assert_in_range(drawing.counts[DRAWN_POLYGON], 30, 60);
	draw_timed(world, "all", ALL, NULL);
	draw_timed(world, "all in a box of 10 m", ALL, &view);
	scree_world_destroy(world);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(culling_is_exact),
	    cmocka_unit_test(states_are_those_of_render_rows),
	    cmocka_unit_test(frozen_bodies_are_red),
	    cmocka_unit_test(many_bodies_are_culled),
	};
	const struct CMUnitTest variants[] = {cmocka_unit_test(drawings_are_equal_on_all_devices)};
	return RUN_ON_DEVICES(tests) + cmocka_run_group_tests(variants, NULL, memory_is_released);
}
