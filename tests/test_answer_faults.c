// SPDX-License-Identifier: MIT
// test_answer_faults.c -- checks that no event, moved body or query result is lost when memory runs out while a program
// reads them.
//
// The test runs a world with sensors, reports, rules and a field once without a fault. Then it repeats the run with one
// failing allocation: in run k, allocation k fails. The call that fails returns an error and is repeated. At the end
// all results are equal to those of the run without a fault. There is one exception: a world that lacks memory for the
// visits of a step is broken.
#include "support/allocations.h"
#include "support/make_bodies.h"
#include "tools/common/byte_hash.h"
#include <stdlib.h>
#include <string.h>

#define ROUNDS 8
#define GROUP  24 // number of bodies that each round adds
#define MOVERS 4

typedef struct
{
	scree_world* world;
	scree_attribute box, ball;
	scree_body last;
	scree_mover movers[MOVERS];
	int round, asked;
	uint64_t answers; // hash of all results that have been read
} Log;

// Adds rows of results to the hash of all results. size: distance between the starts of two rows, bytes. bytes: size of
// the part of each row that is hashed; the rest of a row is padding.
static void log_rows(Log* log, const void* rows, int count, size_t size, size_t bytes)
{
	for (int k = 0; k < count; ++k)
		log->answers = hash_bytes(log->answers, (const char*)rows + size * (size_t)k, bytes);
}
#define LOG(log, rows, count, last) \
	log_rows(log, rows, count, sizeof *(rows), (size_t)((const char*)(&(rows)->last + 1) - (const char*)(rows)))

static scree_status make_world(Log* log)
{
	scree_world_def def = scree_world_def_default();
	def.device = "cpu";
	def.threads = 1;
	return scree_world_create(&def, &log->world);
}

static scree_status make_box(Log* log)
{
	scree_attribute_def def = surface_of(box_shape(0.4f, 0.4f));
	def.material = 3;
	return scree_attribute_create(log->world, &def, &log->box);
}

static scree_status make_ball(Log* log)
{
	scree_attribute_def def = surface_of(circle_shape(0.4f));
	return scree_attribute_create(log->world, &def, &log->ball);
}

static scree_status make_floor(Log* log)
{
	scree_attribute_def surface = surface_of(box_shape(20.0f, 1.0f));
	scree_body_def def = scree_body_def_default();
	scree_status status = scree_attribute_create(log->world, &surface, &def.attribute);
	def.type = SCREE_BODY_STATIC;
	def.pose.position.y = -1.0f;
	def.reports = SCREE_REPORT_TOUCHES | SCREE_REPORT_HITS | SCREE_REPORT_APPROVAL;
	return status ? status : scree_body_create(log->world, &def, &log->last);
}

static scree_status make_sensor(Log* log)
{
	scree_collidable_def def = scree_collidable_def_default();
	def.attribute = log->box;
	def.pose.position.y = 1.0f;
	def.sensor = SCREE_SENSOR_MOVING;
	return scree_collidable_create(log->world, &def, NULL);
}

static scree_status make_field(Log* log)
{
	scree_field_def def = scree_field_def_default(SCREE_FIELD_BUOYANCY);
	return scree_field_create(log->world, &def, NULL);
}

static scree_status set_material(Log* log)
{
	scree_material_pair pair = scree_material_pair_default();
	pair.friction = 0.1f;
	return scree_world_set_material_pair(log->world, 3, 3, &pair);
}

static scree_status add_group(Log* log)
{
	static scree_body_def defs[GROUP];
	scree_body made[GROUP];
	for (int k = 0; k < GROUP; ++k)
	{
		defs[k] = scree_body_def_default();
		defs[k].attribute = k % 2 ? log->box : log->ball;
		defs[k].pose.position = (scree_vec){0.7f * (float)(k % 12) - 4.0f, 0.3f + 0.9f * (float)(k / 12 + log->round)};
		defs[k].reports = (uint32_t)(k % 8);
	}
	scree_status status = scree_bodies_create(log->world, defs, GROUP, made);
	if (status == SCREE_OK)
		log->last = made[GROUP - 1];
	return status;
}

static scree_status exclude(Log* log)
{
	scree_body bodies[2];
	int count;
	scree_status status = scree_world_get_bodies(log->world, bodies, 2, &count);
	return status ? status : scree_body_set_excluded(log->world, log->last, bodies[1], true);
}

static scree_status take_step(Log* log) { return scree_world_step(log->world, STEP, SUBSTEPS); }

static scree_status get_events(Log* log)
{
	scree_events events;
	scree_status status = scree_world_get_events(log->world, &events);
	if (status)
		return status;
	log->asked = events.approval_count;
	LOG(log, events.touches_began, events.touches_began_count, destroyed_b);
	LOG(log, events.touches_ended, events.touches_ended_count, destroyed_b);
	LOG(log, events.hits, events.hit_count, destroyed_b);
	LOG(log, events.visits_began, events.visits_began_count, destroyed_visitor);
	LOG(log, events.visits_ended, events.visits_ended_count, destroyed_visitor);
	LOG(log, events.approvals, events.approval_count, destroyed_b);
	return SCREE_OK;
}

static scree_status answer(Log* log)
{
	static bool answers[ROUNDS * GROUP * 32];
	for (int k = 0; k < log->asked; ++k)
		answers[k] = k % 3 != 0;
	return scree_world_approve_contacts(log->world, answers, log->asked);
}

static scree_status get_moved(Log* log)
{
	scree_moved_bodies list;
	scree_status status = scree_world_get_moved_bodies(log->world, &list);
	if (status == SCREE_OK)
		LOG(log, list.bodies, list.count, velocity);
	return status;
}

static scree_status list_box(Log* log)
{
	scree_query_results list;
	scree_status status = scree_world_overlap_box(log->world, (scree_box){{-9.0f, -3.0f}, {9.0f, 9.0f}}, &list);
	if (status == SCREE_OK)
		LOG(log, list.results, list.count, reserved);
	return status;
}

static scree_status cast_rays(Log* log)
{
	scree_ray rays[ROUNDS * GROUP] = {0};
	scree_query_result found[ROUNDS * GROUP];
	int count = (log->round + 1) * GROUP;
	for (int k = 0; k < count; ++k)
		rays[k] = (scree_ray){.origin = {0.05f * (float)k - 5.0f, 9.0f}, .translation = {0.0f, -20.0f}};
	scree_status status = scree_world_cast_rays(log->world, NULL, rays, count, found);
	if (status == SCREE_OK)
		LOG(log, found, count, reserved);
	return status;
}

static scree_status move(Log* log)
{
	scree_status status = scree_movers_move(log->world, NULL, log->movers, MOVERS, STEP);
	if (status == SCREE_OK)
		LOG(log, log->movers, MOVERS, wall_normal);
	return status;
}

static scree_status blast(Log* log)
{
	scree_blast_def def = scree_blast_def_default();
	int count;
	def.radius = 3.0f;
	scree_status status = scree_world_blast(log->world, &def, &count);
	if (status == SCREE_OK)
		log->answers = hash_bytes(log->answers, &count, sizeof count);
	return status;
}

static scree_status destroy_last(Log* log) { return scree_body_destroy(log->world, log->last); }

typedef scree_status (*Act)(Log* log);
static const Act first[] = {make_world, make_box, make_ball, make_floor, make_sensor, make_field, set_material};
static const Act acts[] = {add_group, exclude,   take_step, get_events, answer,      get_moved,
                           list_box,  cast_rays, move,      blast,      destroy_last};

// Runs all acts. allocations: number of allocations that succeed before one fails; -1: no allocation fails. Returns
// whether an allocation failed. *broken: whether the world broke.
static bool run_once(int allocations, uint64_t* answers, bool* broken)
{
	Log log = {.answers = HASH_BEGIN};
	bool failed = false;
	*broken = false;
	for (int k = 0; k < MOVERS; ++k)
		log.movers[k] = (scree_mover){.position = {(float)k, 6.0f}, .velocity = {1.0f, -2.0f}};
	allocations_left = allocations;
	int begins = (int)(sizeof first / sizeof *first), each = (int)(sizeof acts / sizeof *acts);
	for (int k = 0; k < begins + ROUNDS * each && !*broken; ++k)
	{
		Act act = k < begins ? first[k] : acts[(k - begins) % each];
		log.round = k < begins ? 0 : (k - begins) / each;
		scree_status status = act(&log);
		if (status == SCREE_OK)
			continue;
		assert_false(failed);
		failed = true;
		end_of_shortage(status);
		*broken = log.world && scree_world_wait(log.world) != SCREE_OK;
		--k;
	}
	allocations_left = -1;
	if (!*broken)
	{
		uint64_t hash = hash_of(log.world);
		log.answers = hash_bytes(log.answers, &hash, sizeof hash);
	}
	scree_world_destroy(log.world);
	assert_int_equal(scree_memory(), 0);
	*answers = log.answers;
	return failed;
}

static void no_answer_is_lost(void** state)
{
	(void)state;
	uint64_t expected, answers;
	bool broken;
	int faults = 0, worlds = 0;
	count_allocations();
	assert_false(run_once(-1, &expected, &broken));
	for (; run_once(faults, &answers, &broken); ++faults)
	{
		worlds += broken;
		if (!broken && answers != expected)
			fail_msg("after allocation %d failed, the answers are others", faults);
	}
	print_message("memory ran out in %d places; %d worlds broke\n", faults, worlds);
	assert_true(faults > 100 && worlds < faults / 4);
	OK(scree_hooks_set(NULL));
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(no_answer_is_lost),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
