// SPDX-License-Identifier: MIT
// constants.c -- the constants of a step.
#include "step/constants.h"
#include "step/crowd.h"

// Soft constraint of so many hertz and damping ratio in substeps of h: Catto, Soft Constraints, GDC 2011.
static Softness softness(float hertz, float ratio, float h)
{
	float omega = 6.28318531f * hertz;
	float a1 = 2.0f * ratio + h * omega, a2 = h * omega * a1, a3 = 1.0f / (1.0f + a2);
	return (Softness){.bias_rate = omega / a1, .mass_scale = a2 * a3, .impulse_scale = a3};
}

void step_places(Step* step, const Backend* b)
{
	for (int kind = 0; kind < CONSTRAINT_KINDS; ++kind)
		step->place_capacity[kind] = b->capacity[kind_info[kind].places];
}

Step step_constants(const Pipeline* pipeline, const StepRequest* request)
{
	const scree_tuning* tuning = &request->tuning;
	const Backend* b = pipeline->backend;
	int collidables = request->collidables;
	// a step with dt 0 only detects contacts: nothing divides by dt
	bool moves = request->dt > 0.0f;
	float dt = request->dt, h = dt / (float)request->substeps, rate = moves ? 1.0f / h : 0.0f;

	// A contact under load F sags by F / (m omega^2), so stiff contacts are better: a stack of 20 boxes buckles at 48 Hz
	// (Leonhard Euler, 1778: a column too slender for its weight) and stands at 52. But a pyramid of base 100 stepped at 240 Hz came to rest with a mean square speed of 7e-7 (m/s)^2 at 30 Hz, 1e-5 at 52, 2e-4 at 55
	// and 9e-2 at 60 (damping ratio 15 to 20), with its deepest overlap at 34, 18, 18 and 18 mm.
	float stiffest = 0.22f * rate;
	float hertz = tuning->contact_hertz < stiffest ? tuning->contact_hertz : stiffest;

	// a rotation above pi per step, or pi / 4 per substep, cannot be told from one in the other direction
	float turn = 0.785398163f * (float)request->substeps;
	Step step = {
	    .dt = dt,
	    .h = h,
	    .inv_h = rate,
	    .h_ratio = moves && pipeline->step.h > 0.0f ? h / pipeline->step.h : 1.0f,
	    .gravity_x = request->gravity.x,
	    .gravity_y = request->gravity.y,
	    .max_speed = tuning->max_speed,
	    .max_spin = moves ? (turn < 3.14159265f ? turn : 3.14159265f) / dt : 0.0f,
	    .push_speed = tuning->contact_push_speed,
	    .restitution_threshold = tuning->restitution_threshold,
	    .soft = moves ? softness(hertz, tuning->contact_damping_ratio, h) : (Softness){0},
	    .stiff = moves ? softness(2.0f * hertz, tuning->contact_damping_ratio, h) : (Softness){0},
	    .rolls = pipeline->rolls,
	    .details = request->details || request->reports,
	    .reports = request->reports,
	    .rules = pipeline->rules,
	    .material_pairs = pipeline->material_pairs,
	    .excluded = pipeline->excluded,
	    .asks = pipeline->asks,
	    .allowed = request->allowed_count,
	    .hit_speed = request->hit_speed,
	    .hit_impulse = request->hit_impulse,
	    .bounces = pipeline->bounces,
	    .joints = pipeline->counters.joints > 0,
	    .chain_places = pipeline->chain_places,
	    .drives = pipeline->drives,
	    .couplings = pipeline->couplings,
	    .paths = pipeline->paths,
	    .round = pipeline->round,
	    .guard_way = pipeline->guard_way,
	    .guard_reach = pipeline->guard_reach,
	    .collidables = collidables,
	    .pair_capacity = b->capacity[PER_KEY],
	    .contact_capacity = b->capacity[PER_CONTACT],
	    .contact_limit = contact_limit(request),
	    .walk_nodes = b->walk_nodes,
	    .walkers = b->walkers < collidables ? b->walkers : collidables,
	    .key_bits = index_bits(collidables),
	};
	step_places(&step, b);
	return step;
}
