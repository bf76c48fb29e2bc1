// SPDX-License-Identifier: MIT
// constants.c -- computes the constants of a step, and uploads the list of kinematic bodies.
#include "step/constants.h"
#include "dialect/finite.h"
#include "platform/error.h"
#include "step/contact_capacity.h"
#include "step/reserve.h"
#include <limits.h>
#include <math.h>
#include <string.h>

// Distance at which contacts of small bodies begin, as a multiple of g dt^2, which is twice the fall in a step.
#define FALL_SHARE 0.5f
// m: a step is calm if its fall (FALL_SHARE g dt^2) is smaller than this; with one substep, bodies fall twice as far
#define CALM_FALL (0.125f * SPECULATIVE_DISTANCE)

// Largest frequency of contacts, as a fraction of the substep rate. A light body passes the load of a heavy body on by
// impulses that add up over the passes, and act like a spring of stiffness 2 m / h^2 (m: light mass, h: substep). Only
// softer contacts are damped; at this fraction a contact has 0.55 of that stiffness. At 0.22, pressed balls, a body of
// 500 kg on wheels of 1.6 kg, and pyramids of ten rows under a box of 100 times a box's weight fly apart.
#define CONTACT_STIFFEST (1.0f / 6.0f)

// Light loads need no such limit. A contact is firmer than this limit up to the overlap that FIRM_WEIGHTS times the
// body's own weight causes. Its frequency is multiplied by FIRM_PAIR between bodies that can move, by FIRM_FIXED if one
// cannot, so stacks sink less. The damping is that of the firm part, so impacts do not get deeper. The factors give 52
// and 104 Hz at 240 substeps per second; with larger factors, a pyramid of base 100 never comes to rest.
#define FIRM_WEIGHTS 20.0f
#define FIRM_PAIR    1.3f
#define FIRM_FIXED   2.6f
#define FIRM_GRAVITY 9.8f // m/s^2: minimum gravity for this overlap, so that contacts are firm without gravity

// Frequency of a contact beyond its firm part, as a multiple of contact_hertz after the limit CONTACT_STIFFEST. The
// limit CONTACT_DEEP applies afterwards, and is lower at 60 Hz and 4 or more substeps. With larger values, boxes sink
// deeper under a heavy box: 183 mm with 1 (scene smash, 120 Hz), 191 mm with 1.05, 199 mm with 1.1.
#define CONTACT_SOFT 1.03f

// Largest frequency of deep contacts, as a fraction of the step rate. Normals of round shapes follow the bodies only
// once per step. Under a load N, two round shapes at a distance r push each other aside by a force of N / r per unit of
// displacement, like a spring that is too stiff for a step: 625 disks on 0.66 of their area never rest with 60 Hz and 8
// substeps.
#define CONTACT_DEEP (2.0f / 3.0f)

typedef struct // frequency of contacts of a kind beyond their firm part, Hz; its multiplier in the firm part
{
	float hertz, firm;
} Frequency;

typedef struct // frequencies of contacts between two bodies that can move, and of other contacts
{
	Frequency pair, fixed;
} Frequencies;

// The step must have a length above 0.
static Frequencies frequencies(const StepRequest* request)
{
	float rate = 1.0f / (request->dt / (float)request->substeps);
	float stiffest = CONTACT_STIFFEST * rate, deepest = CONTACT_DEEP / request->dt;
	float contact_hertz = request->tuning.contact_hertz, firm = contact_hertz < stiffest ? contact_hertz : stiffest;
	float soft = CONTACT_SOFT * firm, hertz = soft < deepest ? soft : deepest;
	float fixed = hertz < firm ? firm : hertz;
	return (Frequencies){{hertz, firm / hertz * FIRM_PAIR}, {fixed, firm / fixed * FIRM_FIXED}};
}

// m: Returns Softness.depth. gravity: m/s^2, its magnitude.
static float firm_depth(Frequency f, float gravity)
{
	float omega = 6.28318531f * f.hertz, stiffer = f.firm * f.firm;
	return FIRM_WEIGHTS * gravity / (stiffer * omega * omega);
}

// Source: Erin Catto, Soft Constraints, GDC 2011.
static Softness softness(Frequency f, float ratio, float h, float depth)
{
	float omega = 6.28318531f * f.hertz, stiffer = f.firm * f.firm;
	float a1 = 2.0f * ratio * f.firm + h * omega, a2 = h * omega * a1, a3 = 1.0f / (1.0f + a2);
	return (Softness){
	    .bias_rate = omega / a1, .mass_scale = a2 * a3, .impulse_scale = a3, .firm = stiffer - 1.0f, .depth = depth};
}

// m: Returns the fall of a body in a step, without an upper bound.
static float fall_in(scree_vec gravity, float dt)
{
	return FALL_SHARE * (fabsf(gravity.x) + fabsf(gravity.y)) * dt * dt;
}

BayGravity step_gravity(const StepRequest* request, scree_vec gravity)
{
	float size = sqrtf(gravity.x * gravity.x + gravity.y * gravity.y), fall = fall_in(gravity, request->dt);
	size = size > FIRM_GRAVITY ? size : FIRM_GRAVITY;
	BayGravity values = {.x = flush_tiny(gravity.x),
	                     .y = flush_tiny(gravity.y),
	                     .fall = flush_tiny(fall < SPECULATIVE_DISTANCE ? fall : SPECULATIVE_DISTANCE),
	                     .calm = fall < CALM_FALL};
	if (request->dt > 0.0f)
	{
		Frequencies f = frequencies(request);
		values.pair_depth = firm_depth(f.pair, size);
		values.fixed_depth = firm_depth(f.fixed, size);
	}
	return values;
}

void step_places(Step* step, const Backend* b)
{
	for (int kind = 0; kind < CONSTRAINT_KINDS; ++kind)
		step->place_capacity[kind] = b->capacity[kind_info[kind].places];
}

void step_joints(Step* step, const Pipeline* pipeline)
{
	step->has_drives = pipeline->has_drives;
	step->springs = pipeline->springs;
	step->couplings = pipeline->couplings;
	step->paths = pipeline->paths;
}

void step_bays(Step* step, const Bays* bays)
{
	step->bays = *bays;
	if (bays->worlds == 0)
		return;
	step->contact_limit = MAX_CONTACTS;
	step->traversal_nodes = INT_MAX; // a traversal within a world is short
}

int bays_contacts(const Pipeline* pipeline)
{
	return group_items(pipeline->live_bays << pipeline->bays.contact_bits) + 1;
}

bool step_small(const Pipeline* pipeline)
{
	return pipeline->continuous_way <= CONTINUOUS_TRAVEL * (0.5f * GRAIN_SIZE);
}

Step step_constants(const Pipeline* pipeline, const StepRequest* request)
{
	const scree_tuning* tuning = &request->tuning;
	const Backend* b = pipeline->backend;
	int collidables = request->collidables;
	// a step with dt 0 only finds contacts, so nothing may divide by dt
	bool moves = request->dt > 0.0f;
	float dt = request->dt, h = dt / (float)request->substeps, rate = moves ? 1.0f / h : 0.0f;

	Frequencies f = moves ? frequencies(request) : (Frequencies){{0.0f, 0.0f}, {0.0f, 0.0f}};
	float ratio = tuning->contact_damping_ratio;
	BayGravity gravity = step_gravity(request, request->gravity);
	bool plain = pipeline->counters.joints == 0 && request->fields == 0;

	// limits the spin to pi per step and pi / 4 per substep: more could look like a rotation in the other direction
	float turn = 0.785398163f * (float)request->substeps;
	Step step = {
	    .dt = dt,
	    .h = h,
	    .inv_h = rate,
	    .h_ratio = moves && OF_BATCH(pipeline) && pipeline->lengths_vary ? 0.0f
	               : moves && pipeline->step.h > 0.0f                    ? h / pipeline->step.h
	                                                                     : 1.0f,
	    .gravity_x = gravity.x,
	    .gravity_y = gravity.y,
	    .max_speed = tuning->max_speed,
	    .max_spin = moves ? (turn < 3.14159265f ? turn : 3.14159265f) / dt : 0.0f,
	    .push_speed = flush_tiny(tuning->contact_push_speed),
	    .fall = gravity.fall,
	    .restitution_threshold =
	        tuning->restitution_threshold > ROOT_ABSORBS ? tuning->restitution_threshold : ROOT_ABSORBS,
	    .pair = moves ? softness(f.pair, ratio, h, gravity.pair_depth) : (Softness){0},
	    .fixed = moves ? softness(f.fixed, ratio, h, gravity.fixed_depth) : (Softness){0},
	    .has_rolling = pipeline->has_rolling,
	    .heavy = pipeline->heavy,
	    .belts = pipeline->belts,
	    .segments = pipeline->segments,
	    .details = request->details || request->reports,
	    .reports = request->reports,
	    .rules = pipeline->rules,
	    .material_pairs = pipeline->material_pairs,
	    .excluded = pipeline->excluded,
	    .asks = pipeline->asks,
	    .request_again = request->request_again,
	    .allowed = request->allowed_count,
	    .hit_speed = flush_tiny(request->hit_speed),
	    .hit_impulse = flush_tiny(request->hit_impulse),
	    .bounces = pipeline->bounces,
	    .joints = pipeline->counters.joints > 0,
	    .calm = gravity.calm && (plain || OF_BATCH(pipeline)),
	    .chain_places = pipeline->chain_places,
	    .kinematic = request->kinematic,
	    .presses = pipeline->statics && (request->kinematic > 0 || pipeline->tethers || pipeline->counters.presses > 0),
	    .round = pipeline->round,
	    .small = step_small(pipeline),
	    .sleep = request->sleep || pipeline->sleeps,
	    .sleep_threshold = request->sleep_threshold,
	    .continuous_way = pipeline->continuous_way,
	    .continuous_reach = pipeline->continuous_reach,
	    .collidables = collidables,
	    .pair_capacity = b->capacity[PER_KEY],
	    .contact_capacity = b->capacity[PER_CONTACT],
	    .contact_limit = contact_limit(request),
	    .traversal_nodes = b->traversal_nodes,
	    .traversal_items = b->traversal_items < collidables ? b->traversal_items : collidables,
	    .key_bits = index_bits(collidables),
	};
	if (OF_BATCH(pipeline))
	{
		step_bays(&step, &pipeline->bays);
		step.contact_capacity = bays_contacts(pipeline);
	}
	step_joints(&step, pipeline);
	step_places(&step, b);
	return step;
}

scree_status kinematics_upload(Pipeline* pipeline, const StepRequest* request)
{
	Backend* b = pipeline->backend;
	Kinematics now = {{0}};
	for (int k = 0; k < request->kinematic && k < KINEMATIC_FEW; ++k)
		now.body[k] = request->kinematics[k];
	if (request->kinematic > KINEMATIC_FEW || memcmp(&now, &pipeline->kinematics, sizeof now) == 0)
		return SCREE_OK;
	TRY(b->f->write(b, POOL_kinematics, 0, 1, &now));
	pipeline->kinematics = now;
	return SCREE_OK;
}
