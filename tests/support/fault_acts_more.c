// SPDX-License-Identifier: MIT
// fault_acts_more.c -- acts on joints, fields, queries, snapshots and devices, for tests in which one call fails; the
// list of all acts.
#include "support/fault_acts.h"
#include "support/make_joints.h"
#include <stdlib.h>
#include <string.h>

#define QUERIES 40
#define MOVERS  3
#define FAR     200.0f // m: x of the bodies of this file

static scree_status add_next(FaultRun* s, const scree_joint_def* def)
{
	scree_status status = scree_joint_create(s->world, def, &s->joints[s->joint_count]);
	s->joint_count += status == SCREE_OK;
	return status;
}

// Creates a rope: a row of revolute joints, which is a chain. If it is repeated, it goes on with the joint that failed.
scree_status act_rope(FaultRun* s)
{
	scree_body_def defs[LINKS];
	for (int k = 0; k < LINKS; ++k)
	{
		defs[k] = scree_body_def_default();
		defs[k].attribute = s->circle;
		defs[k].pose.position = (scree_vec){FAR + (float)k, 0.0f};
	}
	scree_status status = s->links[0].index ? SCREE_OK : scree_bodies_create(s->world, defs, LINKS, s->links);
	while (status == SCREE_OK && s->joint_count < LINKS)
	{
		scree_joint_def def = scree_joint_def_make(SCREE_JOINT_REVOLUTE);
		int k = s->joint_count;
		def.body_a = k ? s->links[k - 1] : NOBODY;
		def.body_b = s->links[k];
		def.frame_a.position.x = k ? 1.0f : FAR;
		def.force_threshold = 0.01f;
		status = add_next(s, &def);
	}
	return status;
}

// Adds a gear between two links, and a motor.
scree_status act_couplings(FaultRun* s)
{
	scree_joint_def gear = scree_joint_def_make(SCREE_JOINT_GEAR), motor = scree_joint_def_make(SCREE_JOINT_MOTOR);
	gear.body_a = s->links[2];
	gear.body_b = s->links[5];
	motor.body_a = s->links[3];
	motor.body_b = s->links[7];
	scree_status status = SCREE_OK;
	if (s->joint_count == LINKS)
		status = scree_joint_def_couple(s->world, &gear);
	if (status == SCREE_OK && s->joint_count == LINKS)
		status = add_next(s, &gear);
	return status == SCREE_OK ? add_next(s, &motor) : status;
}

// Holds a body on a path.
scree_status act_path(FaultRun* s)
{
	static const scree_vec points[] = {{FAR, 10.0f}, {FAR + 5.0f, 12.0f}, {FAR + 10.0f, 10.0f}};
	scree_path_def path = scree_path_def_default();
	path.points = points;
	path.count = 3;
	scree_status status = s->path.index ? SCREE_OK : scree_path_create(s->world, &path, &s->path);
	scree_joint_def joint = scree_joint_def_make(SCREE_JOINT_PATH);
	joint.body_b = s->bodies[290];
	joint.path = s->path;
	return status == SCREE_OK ? add_next(s, &joint) : status;
}

scree_status act_field(FaultRun* s)
{
	scree_field_def def = scree_field_def_default(SCREE_FIELD_VORTEX);
	return scree_field_create(s->world, &def, &s->field);
}

scree_status act_unfield(FaultRun* s) { return scree_field_destroy(s->world, s->field); }
scree_status act_unjoint(FaultRun* s) { return scree_joints_destroy(s->world, s->joints + 4, 2); }

scree_status act_material(FaultRun* s)
{
	scree_material_pair pair = scree_material_pair_default();
	pair.friction = 0.1f;
	return scree_world_set_material_pair(s->world, 0, 7, &pair);
}

scree_status act_exclude(FaultRun* s)
{
	static bool excluded[90];
	memset(excluded, 1, sizeof excluded);
	return scree_bodies_set_excluded(s->world, s->bodies, s->bodies + 100, excluded, 90);
}

scree_status act_tuning(FaultRun* s)
{
	scree_tuning tuning;
	scree_status status = scree_world_get_tuning(s->world, &tuning);
	tuning.contact_hertz = 30.0f;
	return status == SCREE_OK ? scree_world_set_tuning(s->world, &tuning) : status;
}

scree_status act_awake(FaultRun* s) { return scree_world_set_awake(s->world, true); }

scree_status act_joint_events(FaultRun* s)
{
	scree_joint_event events[LINKS];
	int count;
	return scree_world_get_joint_events(s->world, events, LINKS, &count);
}

scree_status act_rays(FaultRun* s)
{
	scree_ray rays[QUERIES];
	scree_query_result found[QUERIES];
	for (int k = 0; k < QUERIES; ++k)
		rays[k] = (scree_ray){.origin = {(float)k, 30.0f}, .translation = {0.0f, -60.0f}};
	return scree_world_cast_rays(s->world, NULL, rays, QUERIES, found);
}

scree_status act_casts(FaultRun* s)
{
	scree_shape circle = circle_shape(0.5f);
	scree_probe probes[QUERIES];
	scree_query_result found[QUERIES];
	for (int k = 0; k < QUERIES; ++k)
		probes[k] = (scree_probe){.pose = upright_at((float)k, 30.0f), .translation = {0.0f, -60.0f}};
	return scree_world_cast_shapes(s->world, NULL, &circle, probes, QUERIES, found);
}

scree_status act_nearest(FaultRun* s)
{
	scree_probe probe = {.pose = upright_at(3.0f, 3.0f)};
	scree_query_result found;
	return scree_world_find_nearest(s->world, NULL, NULL, &probe, 1, 100.0f, &found);
}

scree_status act_listed(FaultRun* s)
{
	scree_query_results list;
	return scree_world_overlap_box(s->world, (scree_box){{-50.0f, -50.0f}, {300.0f, 50.0f}}, &list);
}

scree_status act_moved(FaultRun* s)
{
	scree_moved_bodies list;
	return scree_world_get_moved_bodies(s->world, &list);
}

scree_status act_states(FaultRun* s)
{
	static scree_body_state states[2 * BODIES];
	int count;
	return scree_world_get_states(s->world, NULL, states, 2 * BODIES, &count);
}

scree_status act_rows(FaultRun* s)
{
	static scree_render_row rows[2 * BODIES];
	int count;
	return scree_world_get_render_rows(s->world, rows, 2 * BODIES, &count);
}

scree_status act_draw(FaultRun* s)
{
	scree_draw_def def = scree_draw_def_default();
	def.flags = 2 * SCREE_DRAW_LABELS - 1;
	return scree_world_draw(s->world, &def, NULL);
}

scree_status act_visits(FaultRun* s)
{
	scree_visit visits[QUERIES];
	int count;
	return scree_collidable_get_visits(s->world, s->sensor, visits, QUERIES, &count);
}

scree_status act_movers(FaultRun* s)
{
	scree_mover movers[MOVERS];
	for (int k = 0; k < MOVERS; ++k)
		movers[k] = (scree_mover){.position = {3.0f * (float)k, 18.0f}, .velocity = {1.0f, -20.0f}};
	return scree_movers_move(s->world, NULL, movers, MOVERS, STEP);
}

// Moves movers; the slab, which is kinematic, follows the first of them.
scree_status act_walk(FaultRun* s)
{
	scree_mover movers[MOVERS];
	scree_body bodies[MOVERS] = {s->slab_body};
	for (int k = 0; k < MOVERS; ++k)
		movers[k] = (scree_mover){.position = {3.0f * (float)k, 1.0f}, .velocity = {3.0f, -2.0f}};
	return scree_movers_move_bodies(s->world, NULL, movers, bodies, MOVERS, 100.0f, STEP);
}

scree_status act_blast(FaultRun* s)
{
	scree_blast_def def = scree_blast_def_default();
	int count;
	def.radius = 5.0f;
	return scree_world_blast(s->world, &def, &count);
}

scree_status act_snapshot(FaultRun* s)
{
	const void* bytes;
	scree_status status = scree_world_snapshot(s->world, &bytes, &s->saved_size);
	if (status)
		return status;
	s->saved = malloc(s->saved_size);
	assert_non_null(s->saved);
	memcpy(s->saved, bytes, s->saved_size);
	return SCREE_OK;
}

scree_status act_restore(FaultRun* s) { return scree_world_restore(s->world, s->saved, s->saved_size); }

scree_status act_save(FaultRun* s) { return scree_world_save(s->world, 3); }
scree_status act_load(FaultRun* s) { return scree_world_load(s->world, 3); }
scree_status act_discard(FaultRun* s) { return scree_world_discard(s->world, 3); }

scree_status act_clone(FaultRun* s)
{
	scree_world* clone;
	scree_status status = scree_world_clone(s->world, NULL, &clone);
	assert_true((status == SCREE_OK) == (clone != NULL));
	scree_world_destroy(clone);
	return status;
}

// A world on a device moves to the CPU and back.
scree_status act_move_away(FaultRun* s) { return scree_world_move(s->world, "cpu"); }

scree_status act_move_back(FaultRun* s) { return scree_world_move(s->world, s->device ? s->device : "cpu"); }

void fault_run_end(FaultRun* s)
{
	scree_world_destroy(s->world);
	free(s->saved);
	*s = (FaultRun){0};
}

const FaultAct fault_acts[FAULT_ACTS] = {
#define ACT(name, several, opens) {#name, name, several, opens},
#include "support/fault_acts.def"
#undef ACT
};

void check_broken(FaultRun* s, scree_status status)
{
	static const Act refused[] = {
	    act_more_attributes, act_slab,     act_forces,        act_step,
	    act_contacts,        act_overlaps, act_counters,      act_free,
	    act_timings,         act_filter,   act_mass,          act_look,
	    act_enable,          act_target,   act_body_contacts, act_rays,
	    act_casts,           act_nearest,  act_listed,        act_moved,
	    act_states,          act_destroy,  act_rows,          act_blast,
	    act_awake,           act_snapshot, act_move_back,     act_joint_events,
	    act_dress,           act_save,     act_load,          act_movers,
	    act_clone,           act_material, act_exclude,       act_field,
	};
	for (size_t k = 0; k < sizeof refused / sizeof *refused; ++k)
	{
		assert_int_equal(refused[k](s), status);
		assert_non_null(strstr(scree_error(), "the world can only be destroyed"));
	}
	uint64_t hash;
	assert_int_equal(scree_world_get_hash(s->world, &hash), status);
	assert_int_equal(act_draw(s), status);
	assert_int_equal(scree_world_wait(s->world), status);
	assert_int_equal(scree_world_set_gravity(s->world, (scree_vec){0.0f, 0.0f}), status);

	// data that lie only on the host can still be read
	assert_true(scree_body_is_valid(s->world, s->slab_body) || s->slab_body.index == 0);
	assert_true(scree_world_get_device(s->world)[0] != 0);
}
