// SPDX-License-Identifier: MIT
// resolve.c -- executes the fourth stage on the host: resolves one contact after the other, always the most severe.
// Overlaps are resolved first, the deepest first; then closing velocities, the fastest first.
//
// Resolving a contact changes all contacts that share a body with it, so the whole list is searched after each
// resolution, as in the paper. The time grows with the square of the number of contacts, and nothing runs in parallel.
//
// This work is based on: Girgis and Wells, GPGPU Acceleration for Video Game Physics Engines, section III; for the
// impulses: Brian Mirtich, Impulse-based Dynamic Simulation of Rigid Body Systems, 1996.
#include "tools/paper/resolve.h"
#include "constraints/solver_body.h"
#include "platform/error.h"
#include <stdlib.h>

// Maximum number of resolutions per contact. With a lower limit piles fall within ten seconds. A column of ten boxes
// falls with 16 and stands with 64; a column of twenty falls with 64 and stands with 200, but not for thirty seconds.
#define ROUNDS 200

// Smaller overlaps and closing speeds are not resolved.
#define DEPTH_TOLERANCE 0.001f // m
#define SPEED_TOLERANCE 0.001f // m/s

// m: overlap that a resolution leaves. Without it a resting body would lose its contact in every other step, and piles
// would vibrate.
#define DEPTH_LEFT 0.0005f

// m/s: slower impacts do not bounce, so that the speed added by gravity in a step causes no bounce. It equals the
// default of scree_world_def.
#define RESTITUTION_THRESHOLD 1.0f

typedef struct // a contact between two bodies while it is resolved
{
	int a, b; // indices of the bodies
	int count;
	Vec normal;
	Vec arm_a[2], arm_b[2]; // m, from the centers of mass to the points
	float depth;            // m: depth of the deepest point at detection
	float target[2];        // m/s: relative velocity along the normal after the impact; positive: the points separate
	float friction;
	float severity;
} ActiveContact;

typedef struct
{
	Body* bodies;
	ActiveContact* contacts;
	int count;
} Resolution;

static float overlap_severity(const Resolution* r, const ActiveContact* c)
{
	return c->depth - vec_dot(c->normal, vec_sub(r->bodies[c->b].d, r->bodies[c->a].d));
}

// Reduces an overlap to DEPTH_LEFT: moves both bodies along the normal, in inverse proportion to their masses. The
// bodies are not rotated.
static void overlap_resolve(Resolution* r, ActiveContact* c)
{
	Body *a = r->bodies + c->a, *b = r->bodies + c->b;
	Vec shift = vec_scale((c->severity - DEPTH_LEFT) / (a->inv_mass + b->inv_mass), c->normal);
	a->d = vec_sub(a->d, vec_scale(a->inv_mass, shift));
	b->d = vec_add(b->d, vec_scale(b->inv_mass, shift));
}

static Vec relative_velocity(const Resolution* r, const ActiveContact* c, int k)
{
	return vec_sub(body_velocity_at(r->bodies[c->b], c->arm_b[k]), body_velocity_at(r->bodies[c->a], c->arm_a[k]));
}

static float point_severity(const Resolution* r, const ActiveContact* c, int k)
{
	return c->target[k] - vec_dot(c->normal, relative_velocity(r, c, k));
}

static float speed_severity(const Resolution* r, const ActiveContact* c)
{
	float severity = point_severity(r, c, 0);
	return c->count < 2 ? severity : maximum(severity, point_severity(r, c, 1));
}

// Applies an impulse that gives the more severe point its target velocity. Also applies Coulomb friction at this point,
// at most the friction coefficient times the impulse.
static void speed_resolve(Resolution* r, ActiveContact* c)
{
	Body *a = r->bodies + c->a, *b = r->bodies + c->b;
	int k = c->count > 1 && point_severity(r, c, 1) > point_severity(r, c, 0);
	Vec tangent = vec(c->normal.y, -c->normal.x), arm_a = c->arm_a[k], arm_b = c->arm_b[k];

	float impulse = c->severity * body_effective_mass(*a, arm_a, *b, arm_b, c->normal);
	body_push(a, arm_a, b, arm_b, vec_scale(impulse, c->normal));

	float limit = c->friction * impulse;
	float slide = vec_dot(tangent, relative_velocity(r, c, k));
	float drag = -slide * body_effective_mass(*a, arm_a, *b, arm_b, tangent);
	body_push(a, arm_a, b, arm_b, vec_scale(minimum(maximum(drag, -limit), limit), tangent));
}

static bool adjacent(const ActiveContact* c, const ActiveContact* other)
{
	return c->a == other->a || c->a == other->b || c->b == other->a || c->b == other->b;
}

// Resolves the most severe contact repeatedly, until no severity exceeds the tolerance or the limit ROUNDS is reached.
// Contacts of equal severity are resolved in the order of their pairs.
static void resolve_all(Resolution* r, float (*severity)(const Resolution*, const ActiveContact*),
                        void (*resolve)(Resolution*, ActiveContact*), float tolerance)
{
	for (int i = 0; i < r->count; ++i)
		r->contacts[i].severity = severity(r, &r->contacts[i]);
	ActiveContact* last = NULL;
	for (int64_t left = (int64_t)ROUNDS * r->count; left > 0; --left)
	{
		// updates the severity of contacts that share a body with the last one, and finds the most severe contact
		ActiveContact* worst = NULL;
		for (ActiveContact* c = r->contacts; c < r->contacts + r->count; ++c)
		{
			if (last && adjacent(last, c))
				c->severity = severity(r, c);
			if (c->severity > (worst ? worst->severity : tolerance))
				worst = c;
		}
		if (!worst)
			return;
		resolve(r, worst);
		last = worst;
	}
}

static Body load_body(const PaperBody* from)
{
	Body b = {.v = vec(from->vx, from->vy), .w = from->w, .inv_mass = from->inv_mass, .inv_inertia = from->inv_inertia};
	return b;
}

static void store_body(const Body* b, PaperBody* to)
{
	to->vx = to->motion.free_x * b->v.x;
	to->vy = to->motion.free_y * b->v.y;
	to->w = b->w;
	to->pose.x += to->motion.free_x * b->d.x;
	to->pose.y += to->motion.free_y * b->d.y;
}

static Vec arm(const PaperBody* body, Float2 point) { return vec(point.x - body->pose.x, point.y - body->pose.y); }

static ActiveContact active_contact(const PaperBody* bodies, const PaperContact* contact)
{
	ActiveContact c = {
	    .a = contact->body_a, .b = contact->body_b, .count = contact->count, .friction = contact->friction};
	c.normal = vec(contact->normal.x, contact->normal.y);
	for (int k = 0; k < contact->count; ++k)
	{
		c.arm_a[k] = arm(&bodies[c.a], contact->point[k]);
		c.arm_b[k] = arm(&bodies[c.b], contact->point[k]);
		c.depth = maximum(c.depth, -contact->separation[k]);
	}
	return c;
}

// Sets the target velocities. For a point with a gap, the target is the velocity that closes the gap within the step.
// For a point that overlaps, Newton's law of restitution gives the target, or the target is 0 if the closing speed is
// at most RESTITUTION_THRESHOLD.
static void set_targets(const Resolution* r, ActiveContact* c, const PaperContact* contact, float dt)
{
	for (int k = 0; k < c->count; ++k)
	{
		float closing = point_severity(r, c, k), gap = contact->separation[k];
		if (gap > 0.0f)
			c->target[k] = -gap / dt;
		else if (closing > RESTITUTION_THRESHOLD)
			c->target[k] = contact->restitution * closing;
	}
}

static int by_pair(const void* left, const void* right)
{
	const PaperContact *a = left, *b = right;
	return a->a != b->a ? (a->a < b->a ? -1 : 1) : (a->b > b->b) - (a->b < b->b);
}

scree_status paper_resolve(Paper* paper)
{
	PaperPools* p = &paper->pools;
	int count = *p->contact_count;
	qsort(p->contact, (size_t)count, sizeof *p->contact, by_pair);

	size_t body_bytes = (size_t)p->step.bodies * sizeof(Body);
	size_t bytes = body_bytes + (size_t)count * sizeof(ActiveContact);
	if (bytes > paper->scratch_bytes)
	{
		void* larger = scree_allocate(bytes + bytes / 2);
		if (!larger)
			return fail(SCREE_ERROR_OUT_OF_MEMORY, "paper_step: no memory to resolve %d contacts", count);
		scree_release(paper->scratch);
		paper->scratch = larger;
		paper->scratch_bytes = bytes + bytes / 2;
	}
	Resolution r = {paper->scratch, (ActiveContact*)((char*)paper->scratch + body_bytes), 0};
	for (int i = 0; i < p->step.bodies; ++i)
		r.bodies[i] = load_body(&p->body[i]);

	paper->counters.penetration = 0.0f;
	for (int i = 0; i < count; ++i)
	{
		// contacts of collidables without a body are detected, but not resolved
		const PaperContact* contact = &p->contact[i];
		if (contact->body_a < 0 || contact->body_b < 0)
			continue;
		ActiveContact* c = &r.contacts[r.count++];
		*c = active_contact(p->body, contact);
		set_targets(&r, c, contact, p->step.dt);
		paper->counters.penetration = maximum(paper->counters.penetration, c->depth);
	}
	resolve_all(&r, overlap_severity, overlap_resolve, DEPTH_TOLERANCE);
	resolve_all(&r, speed_severity, speed_resolve, SPEED_TOLERANCE);
	for (int i = 0; i < p->step.bodies; ++i)
		if (r.bodies[i].inv_mass > 0.0f)
			store_body(&r.bodies[i], &p->body[i]);
	return SCREE_OK;
}
