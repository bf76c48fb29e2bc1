// SPDX-License-Identifier: MIT
// test_faults.c -- checks that memory may run out and devices may fail, at every call in turn.
//
// A scenario is a list of acts. It runs once without a fault, which gives the expected hash after every act. Then it
// runs many times with one fault, in each run at a later call than before. The act with the fault must return a status
// and a message. There are two cases. If the world is unchanged, the act is repeated, and the hash at the end is the
// expected one. Otherwise the world is broken and can only be destroyed.
#include "support/allocations.h"
#include "support/faulty_device.h"
#include "support/make_bodies.h"
#include "world/upload/upload.h"
#include "world/world.h"
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// ---------------------------------------------------------------------------------------------------------------
// the scenario
// ---------------------------------------------------------------------------------------------------------------

#define BODIES 300 // more bodies than a new world has room for
#define FREE   20

typedef struct
{
	scree_world* world;
	scree_attribute box, circle, slab;
	scree_body bodies[BODIES];
	scree_body slab_body;
	scree_collidable free[FREE];
	bool timings;
} FaultRun;

static scree_status act_create_world(FaultRun* s)
{
	scree_world_def def = scree_world_def_default();
	def.device = "cpu";
	def.threads = 2;
	def.contact_capacity = 8;
	def.timings = s->timings;
	return scree_world_create(&def, &s->world);
}

static scree_status act_attributes(FaultRun* s)
{
	scree_attribute_def box = surface_of(box_shape(0.5f, 0.5f)), circle = surface_of(circle_shape(0.25f));
	scree_attribute_def slab = surface_of(box_shape(30.0f, 0.5f));
	scree_status status = scree_attribute_create(s->world, &box, &s->box);
	if (status == SCREE_OK)
		status = scree_attribute_create(s->world, &circle, &s->circle);
	return status ? status : scree_attribute_create(s->world, &slab, &s->slab);
}

// Creates more attributes than the first table has room for. If the act is repeated after a fault, it does not create
// existing attributes a second time.
static scree_status act_more_attributes(FaultRun* s)
{
	for (int k = 0; k < 80; ++k)
	{
		scree_attribute_def def = surface_of(box_shape(0.5f, 0.5f));
		scree_attribute made;
		def.friction = 0.01f * (float)k;
		scree_status status = scree_attribute_create(s->world, &def, &made);
		if (status)
			return status;
	}
	return SCREE_OK;
}

// Creates a slab that can move, with 100 circles on it. The slab has more contacts than there are colors.
static scree_status act_slab(FaultRun* s)
{
	scree_body_def defs[101];
	for (int k = 0; k <= 100; ++k)
	{
		defs[k] = scree_body_def_default();
		defs[k].attribute = k == 100 ? s->slab : s->circle;
		defs[k].pose.position = k == 100 ? (scree_vec){0.0f, -50.0f} : (scree_vec){-25.0f + 0.5f * (float)k, -49.25f};
	}
	scree_body made[101];
	scree_status status = scree_bodies_create(s->world, defs, 101, made);
	if (status == SCREE_OK)
		s->slab_body = made[100];
	return status;
}

// Creates boxes that overlap, so that each touches several others.
static scree_status act_bodies(FaultRun* s)
{
	static scree_body_def defs[BODIES];
	for (int k = 0; k < BODIES; ++k)
	{
		defs[k] = scree_body_def_default();
		defs[k].attribute = s->box;
		defs[k].pose.position = (scree_vec){0.8f * (float)(k % 20), 0.9f * (float)(k / 20)};
	}
	return scree_bodies_create(s->world, defs, BODIES, s->bodies);
}

static scree_status act_free(FaultRun* s)
{
	scree_collidable_def defs[FREE];
	for (int k = 0; k < FREE; ++k)
	{
		defs[k] = scree_collidable_def_default();
		defs[k].attribute = s->circle;
		defs[k].pose.position = (scree_vec){0.7f * (float)k, 3.0f};
	}
	return scree_collidables_create(s->world, defs, FREE, s->free);
}

static scree_status act_forces(FaultRun* s)
{
	static scree_vec forces[BODIES];
	for (int k = 0; k < BODIES; ++k)
		forces[k] = (scree_vec){(float)(k % 7), 1.0f};
	return scree_bodies_apply_forces(s->world, s->bodies, forces, BODIES);
}

static scree_status act_step(FaultRun* s) { return scree_world_step(s->world, STEP, SUBSTEPS); }

static scree_status act_contacts(FaultRun* s)
{
	static scree_contact contacts[4000];
	int count;
	return scree_world_get_contacts(s->world, contacts, 4000, &count);
}

static scree_status act_overlaps(FaultRun* s)
{
	static scree_contact contacts[100];
	int count;
	return scree_world_get_overlaps(s->world, contacts, 100, &count);
}

static scree_status act_poses(FaultRun* s)
{
	static scree_pose poses[BODIES];
	return scree_bodies_get_poses(s->world, s->bodies, poses, 100);
}

static scree_status act_counters(FaultRun* s)
{
	scree_counters counters;
	return scree_world_get_counters(s->world, &counters);
}

static scree_status act_timings(FaultRun* s)
{
	scree_timings timings;
	return scree_world_get_timings(s->world, &timings);
}

static scree_status act_destroy(FaultRun* s) { return scree_bodies_destroy(s->world, s->bodies + 200, 90); }
static scree_status act_destroy_free(FaultRun* s) { return scree_collidables_destroy(s->world, s->free, 5); }

static scree_status act_again(FaultRun* s)
{
	scree_body_def defs[120];
	for (int k = 0; k < 120; ++k)
	{
		defs[k] = scree_body_def_default();
		defs[k].attribute = k % 3 ? s->circle : s->box;
		defs[k].pose.position = (scree_vec){0.3f * (float)k, 20.0f};
	}
	return scree_bodies_create(s->world, defs, 120, NULL);
}

static scree_status act_type(FaultRun* s) { return scree_body_set_type(s->world, s->slab_body, SCREE_BODY_STATIC); }

static scree_status act_filter(FaultRun* s)
{
	scree_filter filter = scree_filter_default();
	filter.group = 3;
	return scree_collidable_set_filter(s->world, s->free[10], filter);
}

static scree_status act_place(FaultRun* s)
{
	scree_pose pose = {{4.0f, 4.0f}, {1.0f, 0.0f}};
	return scree_collidables_set_poses(s->world, s->free + 7, &pose, 1);
}

static scree_status act_mass(FaultRun* s)
{
	return scree_body_set_mass(s->world, s->bodies[0], (scree_mass){3.0f, 1.0f, {0.0f, 0.0f}});
}

static scree_status switch_bodies(FaultRun* s, bool on)
{
	static bool enabled[BODIES];
	for (int k = 0; k < BODIES; ++k)
		enabled[k] = on;
	return scree_bodies_set_enabled(s->world, s->bodies, enabled, 200);
}

static scree_status act_disable(FaultRun* s) { return switch_bodies(s, false); }
static scree_status act_enable(FaultRun* s) { return switch_bodies(s, true); }
static scree_status act_look(FaultRun* s) { return scree_world_step(s->world, 0.0f, 1); }
static scree_status act_kinematic(FaultRun* s)
{
	return scree_body_set_type(s->world, s->slab_body, SCREE_BODY_KINEMATIC);
}

static scree_status act_target(FaultRun* s)
{
	return scree_body_set_target(s->world, s->slab_body, (scree_pose){{0.5f, -50.0f}, {1.0f, 0.0f}});
}

// Gives another surface to one collidable without a body, and another shape to a second such collidable.
static scree_status act_dress(FaultRun* s)
{
	scree_attribute made;
	scree_attribute_def def = surface_of(circle_shape(0.25f));
	def.friction = 0.987f;
	scree_status status = scree_attribute_create(s->world, &def, &made);
	if (status == SCREE_OK)
		status = scree_collidable_set_attribute(s->world, s->free[10], made);
	return status ? status : scree_collidable_set_attribute(s->world, s->free[11], s->box);
}

static scree_status act_body_contacts(FaultRun* s)
{
	static scree_contact contacts[200];
	int count;
	return scree_body_get_contacts(s->world, s->slab_body, contacts, 200, &count);
}

// Creates a sensor for moving and static collidables.
static scree_status act_sensor(FaultRun* s)
{
	scree_collidable_def def = scree_collidable_def_default();
	def.attribute = s->slab;
	def.sensor = SCREE_SENSOR_MOVING | SCREE_SENSOR_STATIC;
	return scree_collidable_create(s->world, &def, NULL);
}

static scree_status act_events(FaultRun* s)
{
	scree_events events;
	return scree_world_get_events(s->world, &events);
}

typedef scree_status (*Act)(FaultRun* s);
static const Act acts[] = {
    act_create_world,
    act_attributes,
    act_slab,
    act_step,
    act_step,
    act_bodies,
    act_free,
    act_forces,
    act_step,
    act_counters,
    act_poses,
    act_contacts,
    act_more_attributes,
    act_destroy,
    act_type,
    act_step,
    act_again,
    act_destroy_free,
    act_filter,
    act_place,
    act_mass,
    act_step,
    act_overlaps,
    act_timings,
    act_step,
    act_kinematic,
    act_disable,
    act_step,
    act_look,
    act_target,
    act_body_contacts,
    act_dress,
    act_enable,
    act_step,
    act_body_contacts,
    act_look,
    act_step,
    act_sensor,
    act_step,
    act_events,
    act_look,
};
#define ACTS ((int)(sizeof acts / sizeof *acts))

static uint64_t expected[ACTS]; // hash after each act

static void expect(bool timings)
{
	FaultRun s = {.timings = timings};
	for (int k = 0; k < ACTS; ++k)
	{
		OK(acts[k](&s));
		expected[k] = hash_of(s.world);
	}
	scree_counters counters = counters_of(s.world);
	assert_true(counters.reallocations > 3 && counters.contacts > 512);
	scree_world_destroy(s.world);
	assert_int_equal(scree_memory(), 0);
}

// Checks that calls on a broken world return the status of the fault, and that their messages contain "the world can
// only be destroyed".
static void check_broken(FaultRun* s, scree_status status)
{
	static const Act refused[] = {act_more_attributes, act_slab,         act_forces, act_step,    act_contacts,
	                              act_overlaps,        act_counters,     act_free,   act_timings, act_destroy,
	                              act_filter,          act_mass,         act_look,   act_enable,  act_target,
	                              act_dress,           act_body_contacts};
	for (size_t k = 0; k < sizeof refused / sizeof *refused; ++k)
	{
		assert_int_equal(refused[k](s), status);
		assert_non_null(strstr(scree_error(), "the world can only be destroyed"));
	}
	uint64_t hash;
	assert_int_equal(scree_world_get_hash(s->world, &hash), status);
	assert_int_equal(scree_world_wait(s->world), status);
	assert_int_equal(scree_world_set_gravity(s->world, (scree_vec){0.0f, 0.0f}), status);

	// data that lie only on the host can still be read
	assert_true(scree_body_is_valid(s->world, s->slab_body) || s->slab_body.index == 0);
	assert_true(scree_world_get_device(s->world)[0] != 0);
}

// ---------------------------------------------------------------------------------------------------------------
// memory runs out
// ---------------------------------------------------------------------------------------------------------------

// Runs the scenario with one failing allocation. allocations: number of allocations that succeed before this one.
// again: true repeats the failed act; false takes a few steps in place of the remaining acts. Returns whether an
// allocation failed. *broken: increased by 1 if the world broke.
static bool run_with_little_memory(int allocations, bool again, int* broken)
{
	FaultRun s = {0};
	bool failed = false;
	allocations_left = allocations;
	for (int k = 0; k < ACTS; ++k)
	{
		scree_status status = acts[k](&s);
		if (status == SCREE_OK)
			continue;
		assert_false(failed);
		failed = true;
		end_of_shortage(status);
		if (!s.world)
		{
			--k;
			continue;
		}
		if (scree_world_wait(s.world) != SCREE_OK)
		{
			check_broken(&s, SCREE_ERROR_OUT_OF_MEMORY);
			++*broken;
			break;
		}
		if (!again)
		{
			run_steps(s.world, 3);
			break;
		}

		// these acts make several calls, of which the first may have changed the hash before a later one failed
		if (acts[k] != act_attributes && acts[k] != act_more_attributes && acts[k] != act_dress)
			assert_true(hash_of(s.world) == expected[k - 1]);
		--k;
	}
	allocations_left = -1;
	if (again && s.world && scree_world_wait(s.world) == SCREE_OK)
		assert_true(hash_of(s.world) == expected[ACTS - 1]);
	scree_world_destroy(s.world);
	assert_int_equal(scree_memory(), 0);
	return failed;
}

// Returns the distance between the numbers of the failing calls in two successive runs: 1, or 3 in quick builds.
static int stride(void) { return quick() ? 3 : 1; }

static void memory_runs_out(void** state)
{
	(void)state;
	count_allocations();
	expect(false);
	int faults = 0, broken = 0;
	while (run_with_little_memory(faults, true, &broken))
		faults += stride();
	for (int k = 0; k < faults; k += stride())
		assert_true(run_with_little_memory(k, false, &broken));
	print_message("memory ran out in %d places; %d worlds broke\n", faults / stride(), broken / 2);
	assert_true(faults > 100 && broken > 0 && broken < faults);
	OK(scree_hooks_set(NULL));
}

// ---------------------------------------------------------------------------------------------------------------
// the device fails
// ---------------------------------------------------------------------------------------------------------------

// Runs the scenario with a device that fails. calls: number of calls of the device that succeed before the failure.
// Returns whether an act failed. *broken: increased by 1 if the world broke.
static bool run_with_faulty_device(int calls, int* broken)
{
	FaultRun s = {.timings = device_fault.calls != FAULT_RESIZE};
	BackendFunctions functions;
	device_fault.calls_left = -1;
	bool failed = false;
	for (int k = 0; k < ACTS; ++k)
	{
		scree_status status = acts[k](&s);
		if (k == 0)
		{
			OK(status);
			functions = faulty_functions(s.world->backend);
			s.world->backend->f = &functions;
			s.world->backend->distant = true;
			device_fault.calls_left = calls;
		}
		if (status == SCREE_OK)
			continue;
		assert_false(failed);
		assert_int_equal(status, device_fault.status);
		assert_non_null(strstr(scree_error(), "the device"));
		failed = true;
		if (status == SCREE_ERROR_DEVICE_FAILED || scree_world_wait(s.world) != SCREE_OK)
		{
			check_broken(&s, status);
			++*broken;
			break;
		}
		assert_true(hash_of(s.world) == expected[k - 1]);
		--k;
	}
	device_fault.calls_left = -1;
	if (!failed || scree_world_wait(s.world) == SCREE_OK)
		assert_true(hash_of(s.world) == expected[ACTS - 1]);
	scree_world_destroy(s.world);
	assert_int_equal(scree_memory(), 0);
	return failed;
}

static void device_falls(void** state)
{
	(void)state;
	expect(true);
	device_fault = (Fault){.calls = FAULT_COPY | FAULT_WORK, .status = SCREE_ERROR_DEVICE_FAILED};
	int faults = 0, broken = 0;
	while (run_with_faulty_device(faults, &broken))
		faults += stride();
	print_message("the device fell in %d places\n", faults / stride());
	assert_true(faults > 50);
	assert_int_equal(broken, faults / stride());
}

static void device_memory_runs_out(void** state)
{
	(void)state;
	expect(false);
	device_fault = (Fault){.calls = FAULT_RESIZE, .status = SCREE_ERROR_OUT_OF_MEMORY};
	int faults = 0, broken = 0;
	while (run_with_faulty_device(faults, &broken))
		++faults;
	print_message("the device's memory ran out in %d places; %d worlds broke\n", faults, broken);
	assert_true(faults > 5 && broken > 0 && broken < faults);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(memory_runs_out),
	    cmocka_unit_test(device_falls),
	    cmocka_unit_test(device_memory_runs_out),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
