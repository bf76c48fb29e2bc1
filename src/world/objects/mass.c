// SPDX-License-Identifier: MIT
// mass.c -- computes the mass of a body from its collidables.
#include "world/objects/mass.h"
#include "dialect/finite.h"
#include "world/edits.h"
#include "world/objects/attributes.h"
#include "world/objects/joint_ends.h"
#include "world/shape/geometry.h"
#include <math.h>

// Minimum of the squared radius of gyration of a body, as a fraction of the square of HostBody.arm. With a smaller
// fraction, equations of joints keep no digit of the mass: a chain of beads of 2 mm, welded at arms of 0.5 m, got 1e25
// times faster in a step.
#define LEAST_GYRATION 1.0e-3

static scree_mass massless(scree_body_type type)
{
	return (scree_mass){.mass = type == SCREE_BODY_DYNAMIC ? 1.0f : 0.0f};
}

// Adds to the sums those collidables of their body that the sums do not contain yet.
static void add_parts(const scree_world* world, MassSums* sums)
{
	int k = sums->last < 0 ? world->host_bodies[sums->body].first_collidable : world->host_collidables[sums->last].next;
	for (; k >= 0; k = world->host_collidables[k].next)
	{
		const HostCollidable* collidable = world->host_collidables + k;
		const scree_attribute_def* def = world->attributes + collidable->attribute;
		double part = (double)def->density * def->shape.area;
		scree_vec center = pose_point(collidable->pose, def->shape.centroid);
		sums->mass += part;
		sums->x += part * center.x;
		sums->y += part * center.y;
		sums->last = k;
	}
}

// Returns the mass and center of mass from the sums, with inertia 0; the mass is 1 kg if the sum of masses is 0.
static scree_mass mass_of_sums(const MassSums* sums)
{
	if (sums->mass == 0.0)
		return massless(SCREE_BODY_DYNAMIC);
	return (scree_mass){(float)sums->mass, 0.0f, {(float)(sums->x / sums->mass), (float)(sums->y / sums->mass)}};
}

// Returns the inertia about the common center of mass, by the parallel axis theorem; 0 if the sum of masses is 0.
static float inertia_of_sums(const scree_world* world, const MassSums* sums)
{
	if (sums->mass == 0.0)
		return 0.0f;
	double x = sums->x / sums->mass, y = sums->y / sums->mass, inertia = 0.0;
	for (int k = world->host_bodies[sums->body].first_collidable; k >= 0; k = world->host_collidables[k].next)
	{
		const HostCollidable* collidable = world->host_collidables + k;
		const scree_attribute_def* def = world->attributes + collidable->attribute;
		scree_vec center = pose_point(collidable->pose, def->shape.centroid);
		double dx = center.x - x, dy = center.y - y;
		inertia += def->density * ((double)def->shape.inertia + def->shape.area * (dx * dx + dy * dy));
	}
	return (float)inertia;
}

scree_mass mass_of_body(const scree_world* world, int body)
{
	const HostBody* host = world->host_bodies + body;
	if (host->type != SCREE_BODY_DYNAMIC)
		return massless(host->type);
	if (host->own_mass.mass > 0.0f)
		return host->own_mass;
	MassSums sums = {.body = body, .last = -1};
	add_parts(world, &sums);
	scree_mass mass = mass_of_sums(&sums);
	mass.inertia = inertia_of_sums(world, &sums);
	return mass;
}

scree_mass mass_now(const scree_world* world, int body)
{
	bool lacks = world->mass_sums.body == body && world->mass_sums.command > 0;
	return lacks ? mass_of_body(world, body) : world->host_bodies[body].mass;
}

// m: Returns the distance of a point from the center of mass, without hypotf, whose bits differ between systems.
static float arm_of(const HostBody* host, scree_vec point)
{
	double x = point.x - host->mass.center.x, y = point.y - host->mass.center.y;
	return (float)sqrt(x * x + y * y);
}

float mass_inverse(const HostBody* host) { return host->mass.mass > 0.0f ? 1.0f / host->mass.mass : 0.0f; }

float mass_inverse_inertia(const HostBody* host)
{
	bool turns = host->mass.inertia > 0.0f && !(host->locks & SCREE_LOCK_ROTATION);
	float least = (float)(LEAST_GYRATION * host->mass.mass * host->arm * host->arm);
	return turns ? 1.0f / fmaxf(host->mass.inertia, fminf(least, MOST_INERTIA)) : 0.0f;
}

float mass_arm(const scree_world* world, const HostBody* host)
{
	float most = 0.0f;
	for (int end = host->first_joint; end > 0; end = joint_next(world, end))
	{
		const scree_joint_def* def = &world->host_joints[joint_of_end(end)].def;
		most = fmaxf(most, arm_of(host, (end - 1) % 2 == 0 ? def->frame_a.position : def->frame_b.position));
	}
	for (int k = host->first_collidable; host->own_mass.mass > 0.0f && k >= 0; k = world->host_collidables[k].next)
	{
		const HostCollidable* collidable = world->host_collidables + k;
		if (collidable->sensor == 0)
			most = fmaxf(most, world->attributes[collidable->attribute].shape.reach +
			                       arm_of(host, collidable->pose.position));
	}
	return most;
}

bool mass_is_heavy(const scree_world* world, int body, scree_mass mass)
{
	HostBody host = world->host_bodies[body];
	host.mass = host.own_mass = mass;
	host.arm = mass_arm(world, &host);
	return edits_heavy(mass_inverse(&host), mass_inverse_inertia(&host));
}

ContinuousBody continuous_row(scree_world* world, int body)
{
	const HostBody* host = world->host_bodies + body;
	ContinuousBody continuous_body = {.first = host->first_collidable + 1, .parts = 1, .way = INFINITY};
	int count = 0;
	for (int k = host->first_collidable; host->type == SCREE_BODY_DYNAMIC && k >= 0;
	     k = world->host_collidables[k].next)
	{
		// continuous collision uses |x| + |y| of the arm, at most 1.4143 times its length; 1.001 allows for rounding
		const HostCollidable* collidable = world->host_collidables + k;
		float way = CONTINUOUS_TRAVEL * attribute_thickness(world, collidable->attribute);
		float reach = 1.001f * (world->attributes[collidable->attribute].shape.reach +
		                        1.4143f * arm_of(host, collidable->pose.position));
		continuous_body.way = way < continuous_body.way ? way : continuous_body.way;
		continuous_body.reach = reach > continuous_body.reach ? reach : continuous_body.reach;
		++count;
	}
	if (count > CONTINUOUS_SHARE)
		continuous_body.parts =
		    count < CONTINUOUS_SHARE * CONTINUOUS_PARTS ? count / CONTINUOUS_SHARE : CONTINUOUS_PARTS;
	Pipeline* pipeline = &world->pipeline;
	pipeline->continuous_way =
	    continuous_body.way < pipeline->continuous_way ? continuous_body.way : pipeline->continuous_way;
	pipeline->continuous_reach =
	    continuous_body.reach > pipeline->continuous_reach ? continuous_body.reach : pipeline->continuous_reach;
	return continuous_body;
}

Command continuous_command(scree_world* world, int body)
{
	ContinuousBody continuous_body = continuous_row(world, body);
	return (Command){.kind = COMMAND_CONTINUOUS,
	                 .index = body,
	                 .whole = {continuous_body.first, continuous_body.parts},
	                 .value = make_float4(continuous_body.way, continuous_body.reach, 0.0f, 0.0f)};
}

static void mass_command(scree_world* world, int body)
{
	const HostBody* host = world->host_bodies + body;
	scree_vec center = host->mass.center;
	Float4 value = make_float4(mass_inverse(host), mass_inverse_inertia(host), center.x, center.y);
	edits_command(world, COMMAND_MASS, body, value, 0);
}

static void send_mass(scree_world* world, int body, scree_mass mass)
{
	HostBody* host = world->host_bodies + body;
	host->mass = mass;
	host->arm = mass_arm(world, host);
	world->chains_stale |= host->first_joint > 0; // chains depend on the ratios of masses
	mass_command(world, body);
}

void mass_anchor(scree_world* world, int body, scree_vec anchor)
{
	HostBody* host = world->host_bodies + body;
	if (host->type != SCREE_BODY_DYNAMIC)
		return;
	mass_settle(world);
	float before = mass_inverse_inertia(host), arm = arm_of(host, anchor);
	host->arm = arm > host->arm ? arm : host->arm;
	if (mass_inverse_inertia(host) != before)
		mass_command(world, body);
}

void mass_touches(scree_world* world, int body)
{
	if (body >= 0 && world->host_bodies[body].own_mass.mass > 0.0f &&
	    world->host_bodies[body].type == SCREE_BODY_DYNAMIC)
		send_mass(world, body, world->host_bodies[body].mass);
}

void mass_set(scree_world* world, int body, scree_mass mass)
{
	mass_forget(world, body);
	send_mass(world, body, mass);
	edits_whole(world, continuous_command(world, body));
}

void mass_forget(scree_world* world, int body)
{
	if (world->mass_sums.body == body)
		world->mass_sums = (MassSums){0};
}

void mass_settle(scree_world* world)
{
	MassSums* sums = &world->mass_sums;
	if (sums->command == 0)
		return;
	HostBody* host = world->host_bodies + sums->body;
	host->mass.inertia = inertia_of_sums(world, sums);
	world->edits.commands[sums->command - 1].value.y = mass_inverse_inertia(host);
	sums->command = 0;
	edits_whole(world, continuous_command(world, sums->body));
}

// Adds new collidables of a dynamic body to its mass; the inertia is then pending. If the sums are those of another
// body, computes the inertia of that body, and begins new sums.
static void gain(scree_world* world, int body)
{
	MassSums* sums = &world->mass_sums;
	if (sums->body != body)
	{
		mass_settle(world);
		*sums = (MassSums){.body = body, .last = -1};
	}
	add_parts(world, sums);
	send_mass(world, body, mass_of_sums(sums));
	sums->command = world->edits.command_count;
}

void mass_own(scree_world* world, int body, scree_mass mass)
{
	world->host_bodies[body].own_mass = mass;
	world->own_masses = true;
	mass_set(world, body, mass);
}

void masses_update(scree_world* world, const int* bodies, int count, bool gained)
{
	for (int k = 0; k < count; ++k)
	{
		if (bodies[k] >= 0)
			world->host_bodies[bodies[k]].marked = true;
	}
	for (int k = 0; k < count; ++k)
	{
		if (bodies[k] < 0 || !world->host_bodies[bodies[k]].marked)
			continue;
		world->host_bodies[bodies[k]].marked = false;
		world->host_bodies[bodies[k]].own_mass = (scree_mass){0};
		if (world->host_bodies[bodies[k]].type != SCREE_BODY_DYNAMIC)
			// the list of the body may now begin with another collidable
			edits_whole(world, continuous_command(world, bodies[k]));
		else if (gained)
			gain(world, bodies[k]);
		else
			mass_set(world, bodies[k], mass_of_body(world, bodies[k]));
	}
}
