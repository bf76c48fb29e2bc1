// SPDX-License-Identifier: MIT
// test_bad_draws.c -- checks that bad arguments and a lack of memory are refused before anything is drawn.
#include "support/allocations.h"
#include "support/bad_input.h"
#include "support/draw_log.h"
#include <math.h>
#include <string.h>

static DrawLog drawing;

static void definitions(void** state)
{
	(void)state;
	scree_draw_def def = log_def(&drawing, SCREE_DRAW_SHAPES);
	INVALID(scree_world_draw, (NULL, &def, NULL), "world is null");
	INVALID(scree_world_draw, (world, NULL, NULL), "def is null");
	def.size = 0;
	INVALID(scree_world_draw, (world, &def, NULL),
	        "def.size is 0: the definition was not made by scree_draw_def_default");
#define DRAW(change, sentence)                  \
	def = log_def(&drawing, SCREE_DRAW_SHAPES); \
	def.change;                                 \
	INVALID(scree_world_draw, (world, &def, NULL), "def" sentence)
	DRAW(flags = 1024, ".flags is 0x400, has bits beyond SCREE_DRAW_*");
	DRAW(impulse_scale = NAN, ".impulse_scale is nan");
	DRAW(impulse_scale = -1.0f, ".impulse_scale is -1, must be from 0 to 1000000");
	DRAW(speed_scale = INFINITY, ".speed_scale is inf");
	DRAW(speed_scale = 2e6f, ".speed_scale is 2000000");
	DRAW(length = -0.5f, ".length is -0.5, must be from 0 to 100000");
#undef DRAW
	assert_int_equal(drawing.total, 0);
}

static void boxes(void** state)
{
	(void)state;
	scree_draw_def def = log_def(&drawing, SCREE_DRAW_SHAPES);
	scree_collidable_state states[4];
	int count = 7;
	const scree_box bad[] = {{{1, 0}, {0, 1}}, {{0, 1}, {1, 0}}, {{NAN, 0}, {1, 1}}, {{0, 0}, {1, NAN}}};
	for (size_t k = 0; k < sizeof bad / sizeof *bad; ++k)
	{
		INVALID(scree_world_draw, (world, &def, bad + k), "must have a lower corner below its upper one");
		INVALID(scree_world_get_collidable_states, (world, bad + k, states, 4, &count), "box from (");
	}
	INVALID(scree_world_get_collidable_states, (NULL, NULL, states, 4, &count), "world is null");
	INVALID(scree_world_get_collidable_states, (world, NULL, NULL, 4, &count), "states is null");
	INVALID(scree_world_get_collidable_states, (world, NULL, states, -1, &count), "capacity is -1");
	INVALID(scree_world_get_collidable_states, (world, NULL, states, 4, NULL), "count is null");
	assert_int_equal(count, 7);
	assert_int_equal(drawing.total, 0);
}

// A program with a shorter definition or result gets the members that it has; one with a longer definition is refused if it
// sets a member that the library lacks.
static void other_versions(void** state)
{
	(void)state;
	struct
	{
		scree_draw_def def;
		uint64_t later;
	} newer = {.later = 0};
	scree_draw_def_default_sized(&newer.def, sizeof newer);
	assert_int_equal(newer.def.size, sizeof newer);
	OK(scree_world_draw(world, &newer.def, NULL));
	newer.later = 1;
	INVALID(scree_world_draw, (world, &newer.def, NULL), "def sets a member at byte ");
	unsigned char states[4][16];
	scree_collidable_state* older = (scree_collidable_state*)(void*)states;
	int count;
	OK(scree_world_get_collidable_states_sized(world, NULL, older, sizeof *states, 4, &count));
	assert_int_equal(count, 4);
	assert_memory_equal(states[1], &part, sizeof part);
}

typedef struct // a world whose drawing functions use it
{
	scree_world* world;
	scree_body crate;
	int calls;
} Used;

static int warnings;

static void count_warnings(scree_log_level level, const char* sentence, void* context)
{
	(void)context;
	warnings += level == SCREE_LOG_WARNING && strstr(sentence, "scree_world_destroy: ") != NULL;
}

static void use_the_world(const scree_vec* vertices, int count, float radius, uint32_t color, void* context)
{
	(void)count, (void)radius, (void)color;
	static DrawLog inner;
	const scree_draw_def def = log_def(&inner, SCREE_DRAW_SHAPES);
	Used* used = context;
	scree_query_result found;
	const void* bytes;
	size_t size;
	++used->calls;
	const scree_status refused[] = {
	    scree_world_step(used->world, 1.0f / 60.0f, 4),
	    scree_body_create_box(used->world, SCREE_BODY_DYNAMIC, upright_at(0.0f, 9.0f), 1.0f, 1.0f, 0, NULL),
	    scree_body_destroy(used->world, used->crate),
	    scree_world_cast_ray(used->world, vertices[0], (scree_vec){0.0f, 1.0f}, &found),
	    scree_world_snapshot(used->world, &bytes, &size),
	    scree_world_draw(used->world, &def, NULL),
	};
	for (size_t k = 0; k < sizeof refused / sizeof *refused; ++k)
		assert_int_equal(refused[k], SCREE_ERROR_INVALID);
	assert_string_equal(scree_error(),
	                    "scree_world_draw: a function that draws for scree_world_draw must not use its world");
	assert_int_equal(inner.total, 0);
	scree_world_destroy(used->world);
}

// Functions that draw use the world of the call: each use is refused, all shapes are drawn, and the world stays as it was.
static void functions_that_use_the_world(void** state)
{
	(void)state;
	OK(scree_hooks_set(&(scree_hooks){.log = count_warnings}));
	Used used = {.world = open_world(-10.0f)};
	used.crate = add_crate(used.world, SCREE_BODY_DYNAMIC, 0.0f, 0.5f);
	add_crate(used.world, SCREE_BODY_DYNAMIC, 3.0f, 0.5f);
	scree_draw_def def = log_def(&drawing, SCREE_DRAW_SHAPES);
	uint64_t first, last;
	OK(scree_world_get_hash(used.world, &first));
	def.polygon = use_the_world;
	def.context = &used;
	OK(scree_world_draw(used.world, &def, NULL));
	assert_int_equal(used.calls, 2);
	assert_int_equal(warnings, 2);
	OK(scree_world_get_hash(used.world, &last));
	assert_true(first == last);
	def = log_def(&drawing, SCREE_DRAW_SHAPES);
	OK(scree_world_draw(used.world, &def, NULL));
	assert_int_equal(drawing.counts[DRAWN_POLYGON], 2);
	run_steps(used.world, 1);
	scree_world_destroy(used.world);
	OK(scree_hooks_set(NULL));
}

// Lets memory run out at each allocation in turn. The call fails before it draws, and then succeeds.
static void memory_runs_out(void** state)
{
	(void)state;
	count_allocations();
	scree_world* drawn = open_world(-10.0f);
	add_floor(drawn);
	scree_body crate_body = add_crate(drawn, SCREE_BODY_DYNAMIC, 0.0f, 0.5f);
	run_steps(drawn, 5);
	OK(scree_body_set_enabled(drawn, add_crate(drawn, SCREE_BODY_DYNAMIC, 5.0f, 0.5f), false));
	OK(scree_body_set_pose(drawn, crate_body, upright_at(0.0f, 0.6f)));
	int refused = 0;
	for (bool done = false; !done;)
	{
		scree_draw_def def = log_def(&drawing, 2 * SCREE_DRAW_LABELS - 1);
		allocations_left = refused;
		scree_status status = scree_world_draw(drawn, &def, NULL);
		done = status == SCREE_OK;
		if (done)
			continue;
		end_of_shortage(status);
		assert_int_equal(drawing.total, 0);
		++refused;
	}
	allocations_left = -1;
	assert_true(refused > 4 && drawing.total > 0);
	scree_world_destroy(drawn);
	OK(scree_hooks_set(NULL));
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(definitions),
	    cmocka_unit_test(boxes),
	    cmocka_unit_test(other_versions),
	};
	const struct CMUnitTest own_worlds[] = {
	    cmocka_unit_test(functions_that_use_the_world),
	    cmocka_unit_test(memory_runs_out),
	};
	return cmocka_run_group_tests(tests, set_up_bad_input, tear_down_bad_input) +
	       cmocka_run_group_tests(own_worlds, NULL, memory_is_released);
}
