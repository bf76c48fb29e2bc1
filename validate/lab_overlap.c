// SPDX-License-Identifier: MIT
// lab_overlap.c -- measures the overlaps of the bodies of a lab, and the gaps of its joints.
#include "lab_overlap.h"
#include "engine_scree.h"
#include "experiment_support.h"
#include "scree_world.h"
#include <math.h>
#include <stdlib.h>

#define MOMENT 1.0e-4f // s: time of a step in which bodies hardly move

// Writes the position of an anchor in the world. lab->poses contains the poses of the bodies' origins, not of their
// centers of mass.
static void anchor_of(const Lab* lab, int body, scree_vec anchor, double at[2])
{
	scree_pose pose = lab->poses[body];
	double x = (double)anchor.x, y = (double)anchor.y, c = (double)pose.rotation.c, s = (double)pose.rotation.s;
	at[0] = (double)pose.position.x + (c * x - s * y);
	at[1] = (double)pose.position.y + (s * x + c * y);
}

double lab_gap(const Lab* lab)
{
	double most = 0.0;
	for (int k = 0; k < lab->joint_count; ++k)
	{
		double a[2], b[2];
		anchor_of(lab, lab->joints[k].a, lab->joints[k].def.frame_a.position, a);
		anchor_of(lab, lab->joints[k].b, lab->joints[k].def.frame_b.position, b);
		most = larger(most, hypot(b[0] - a[0], b[1] - a[1]));
	}
	return most;
}

static bool measure(const Lab* lab, void* state, const EngineBody* bodies, scree_counters* counters)
{
	return scree_engine.create(state, bodies, lab->count) && scree_engine.step(state, MOMENT, 1) &&
	       report_status(scree_world_get_counters(scree_engine.world(state), counters));
}

double lab_overlap(Lab* lab, int* touches)
{
	lab_read(lab);
	if (lab->validation->broken)
		return 0.0;
	// copies of the bodies at rest, at their present poses
	EngineBody* still = require_memory(malloc(((size_t)lab->count + 1) * sizeof *still));
	for (int k = 0; k < lab->count; ++k)
	{
		still[k] = lab->bodies[k];
		still[k].def.pose = lab->poses[k];
		still[k].def.velocity = (scree_velocity){{0.0f, 0.0f}, 0.0f};
	}
	EngineOptions options = {.device = "cpu", .threads = 1};
	EngineDef def = {scree_world_def_default(), lab->def.max_speed, lab->def.contact_hertz};
	def.world.gravity = (scree_vec){0.0f, 0.0f};
	void* state = scree_engine.open(&options, &def);
	scree_counters counters = {0};
	bool good = state && measure(lab, state, still, &counters);
	lab->validation->broken = !good;
	for (int k = 0; touches && k < lab->count; ++k)
		touches[k] = good ? engine_overlaps(state, k) : 0;
	if (state)
		scree_engine.close(state);
	free(still);
	return (double)counters.penetration;
}
