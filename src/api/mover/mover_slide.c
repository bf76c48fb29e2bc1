// SPDX-License-Identifier: MIT
// mover_slide.c -- the parts of a mover's motion: each is a few rounds of queries, for all movers of a call at once.
#include "api/mover/mover_slide.h"
#include "world/check.h"
#include "world/failure.h"
#include <math.h>

#define RECOVER_ROUNDS 8
#define SLIDE_ROUNDS   5
#define TOUCH          1e-4f // m: so much nearer than the skin counts as too near
#define BESIDE         0.02f // m: from the corner of a step to where the top of it is looked for

static void ask(Walk* walk, int k, scree_vec from, scree_vec translation)
{
	walk->probes[walk->asked] = (scree_probe){.pose = {from, {1.0f, 0.0f}}, translation, walk->movers[k].ignored};
	walk->of[walk->asked++] = k;
}

// How far a probe may go, m: where it is the skin away from the surface.
static float free_length(const Walk* walk, int k)
{
	scree_vec way = walk->probes[k].translation;
	const scree_found* found = walk->found + k;
	float length = sqrtf(dot(way, way));
	if (!found->hit)
		return length;
	float into = -dot(way, found->normal) / length;
	float s = found->fraction * length - walk->def->skin / (into > 1e-6f ? into : 1e-6f);
	return s > 0.0f ? s : 0.0f;
}

// Casts the probes. The surface that is met first need not be the one that comes too near first, so a shape with the skin around it is
// cast as well. It does not see what is in the skin already, so it is thinner by what walk_recover leaves.
static scree_status cast(Walk* walk)
{
	scree_found* wide = walk->found + walk->count;
	scree_shape shape = walk->shape;
	float skin = walk->def->skin > 4.0f * TOUCH ? walk->def->skin - 2.0f * TOUCH : 0.5f * walk->def->skin;
	shape.radius += skin;
	TRY(scree_world_cast_shapes(walk->world, &walk->seen, &walk->shape, walk->probes, walk->asked, walk->found));
	TRY(scree_world_cast_shapes(walk->world, &walk->seen, &shape, walk->probes, walk->asked, wide));
	for (int k = 0; k < walk->asked; ++k)
	{
		scree_vec way = walk->probes[k].translation;
		float length = sqrtf(dot(way, way)), into = -dot(way, wide[k].normal) / length;
		if (!wide[k].hit || into <= 1e-6f || wide[k].fraction * length >= free_length(walk, k))
			continue;
		walk->found[k] = wide[k];
		walk->found[k].fraction += skin / (into * length);
	}
	return SCREE_OK;
}

scree_vec walk_within(scree_vec at)
{
	return (scree_vec){fminf(fmaxf(at.x, -SCREE_HUGE), SCREE_HUGE), fminf(fmaxf(at.y, -SCREE_HUGE), SCREE_HUGE)};
}

static scree_vec free_end(const Walk* walk, int k)
{
	scree_vec way = walk->probes[k].translation;
	float length = sqrtf(dot(way, way));
	return length > 0.0f ? walk_within(add_scaled(walk->probes[k].pose.position, free_length(walk, k) / length, way))
	                     : walk->probes[k].pose.position;
}

static bool is_ground(const Walk* walk, scree_vec normal) { return dot(normal, walk->def->up) >= walk->steepest; }

// v without its part against the normal
static scree_vec clip(scree_vec v, scree_vec normal)
{
	float against = dot(v, normal);
	return against < 0.0f ? add_scaled(v, -against, normal) : v;
}

// The same for a surface that a walker meets. On one that is too steep to stand on it does not go up unless it rises by itself.
static scree_vec deflect(const Walk* walk, scree_vec v, scree_vec normal)
{
	scree_vec up = walk->def->up, free = clip(v, normal);
	float rises = dot(v, up), steep = dot(normal, up);
	scree_vec level = add_scaled(normal, -steep, up);
	float length = sqrtf(dot(level, level));
	if (steep <= 0.0f || length == 0.0f || is_ground(walk, normal) || dot(free, up) <= (rises > 0.0f ? rises : 0.0f))
		return free;
	return clip(v, (scree_vec){level.x / length, level.y / length});
}

// A surface stops a walker: its way and its velocity lose what points into it.
static void meet(const Walk* walk, Walker* w, scree_collidable collidable, scree_vec normal)
{
	scree_vec up = walk->def->up;
	if (is_ground(walk, normal))
	{
		// on ground only the fall ends: a slope that can be walked does not pull
		w->velocity = clip(w->velocity, up);
		w->rest = clip(w->rest, up);
		if (dot(w->velocity, up) <= 0.0f)
		{
			w->ground = collidable;
			w->normal = normal;
		}
	}
	else
	{
		w->wall = collidable;
		w->wall_normal = normal;
		w->kept = w->velocity;
		w->push = w->stood ? w->rest : (scree_vec){0.0f, 0.0f};
		// who stands does not fall against a wall
		float fall = w->stood && dot(w->velocity, up) < 0.0f ? dot(w->velocity, up) : 0.0f;
		w->velocity = add_scaled(deflect(walk, add_scaled(w->velocity, -fall, up), normal), fall, up);
	}
	w->rest = deflect(walk, w->rest, normal);
	if (dot(w->rest, w->last) < -1e-6f)
		w->rest = (scree_vec){0.0f, 0.0f}; // between two surfaces
	w->last = normal;
}

// Nothing pushes it: what has passed its middle would push it out on the other side.
void walk_crush(const Walk* walk, int k, scree_collidable by)
{
	walk->walkers[k] = (Walker){.at = walk->movers[k].position, .wall = by, .crushed = true};
}

scree_status walk_crushed(Walk* walk)
{
	walk->asked = 0;
	for (int k = 0; k < walk->count; ++k)
		if (walk->walkers[k].crushed)
			ask(walk, k, walk->walkers[k].at, (scree_vec){0});
	if (walk->asked == 0)
		return SCREE_OK;
	TRY(scree_world_find_nearest(walk->world, &walk->seen, &walk->shape, walk->probes, walk->asked, walk->def->skin,
	                             walk->found));
	for (int k = 0; k < walk->asked; ++k)
	{
		const scree_found* found = walk->found + k;
		if (found->hit && found->fraction < -TOUCH)
			walk_crush(walk, walk->of[k], found->collidable);
		else
			walk->walkers[walk->of[k]].crushed = false;
	}
	return SCREE_OK;
}

scree_status walk_recover(Walk* walk)
{
	for (int round = 0; round < RECOVER_ROUNDS; ++round)
	{
		// all in the first round, then those that moved
		int asked = round == 0 ? walk->count : walk->asked;
		walk->asked = 0;
		for (int k = 0; k < asked; ++k)
		{
			int i = round == 0 ? k : walk->of[k];
			if (!walk->walkers[i].crushed)
				ask(walk, i, walk->walkers[i].at, (scree_vec){0});
		}
		if (walk->asked == 0)
			break;
		TRY(scree_world_find_nearest(walk->world, &walk->seen, &walk->shape, walk->probes, walk->asked, walk->def->skin,
		                             walk->found));
		int moved = 0;
		for (int k = 0; k < walk->asked; ++k)
		{
			const scree_found* found = walk->found + k;
			float lacks = found->hit ? walk->def->skin - found->fraction : 0.0f;
			if (lacks <= TOUCH)
				continue;
			Walker* w = walk->walkers + walk->of[k];
			if (round == RECOVER_ROUNDS - 1 && found->fraction < -TOUCH)
			{
				walk_crush(walk, walk->of[k], found->collidable);
				continue;
			}
			w->at = walk_within(add_scaled(w->at, lacks, found->normal));
			meet(walk, w, found->collidable, found->normal);
			w->ground = SCREE_NULL_COLLIDABLE;
			w->push = (scree_vec){0.0f, 0.0f};
			walk->of[moved++] = walk->of[k];
		}
		walk->asked = moved;
		if (moved == 0)
			break;
	}
	for (int k = 0; k < walk->count; ++k)
		walk->walkers[k].last = (scree_vec){0.0f, 0.0f};
	return SCREE_OK;
}

// Whether each of the asked stands on what it met: on ground, or on a corner, beside which there is ground and which is low
// enough for the round end of the capsule to be pushed up. Answers overwrite found[].hit.
static scree_status find_ground(Walk* walk)
{
	const scree_mover_def* def = walk->def;
	int rays = 0;
	for (int k = 0; k < walk->asked; ++k)
	{
		scree_found* found = walk->found + k;
		float rises = dot(found->normal, def->up);
		if (!found->hit || is_ground(walk, found->normal))
			continue;
		found->hit = rises > 0.0f && (1.0f - rises) * def->radius <= def->climb;
		if (!found->hit)
			continue;
		float out = dot(found->normal, walk->along) > 0.0f ? -BESIDE : BESIDE;
		scree_vec from = walk_within(add_scaled(add_scaled(found->point, out, walk->along), BESIDE, def->up));
		walk->rays[rays++] = (scree_ray){.origin = from,
		                                 .translation = add_scaled((scree_vec){0}, -3.0f * BESIDE, def->up),
		                                 .ignored = walk->movers[walk->of[k]].ignored};
	}
	if (rays == 0)
		return SCREE_OK;
	scree_found* beside = walk->found + walk->count;
	TRY(scree_world_cast_rays(walk->world, &walk->seen, walk->rays, rays, beside));
	for (int k = 0, ray = 0; k < walk->asked; ++k)
		if (walk->found[k].hit && !is_ground(walk, walk->found[k].normal))
		{
			walk->found[k].hit = beside[ray].hit && is_ground(walk, beside[ray].normal);
			++ray;
		}
	return SCREE_OK;
}

// Walkers whom a wall stopped try to go on a step higher: up, on and down again. Those that do not end on ground stay.
static scree_status climb(Walk* walk)
{
	const scree_mover_def* def = walk->def;
	scree_vec up = def->up;
	walk->asked = 0;
	for (int k = 0; k < walk->count; ++k)
		if (dot(walk->walkers[k].push, walk->walkers[k].push) > 0.0f)
			ask(walk, k, walk->walkers[k].at, add_scaled((scree_vec){0}, def->climb + def->skin, up));
	if (walk->asked == 0)
		return SCREE_OK;
	TRY(cast(walk));
	for (int k = 0; k < walk->asked; ++k)
	{
		const Walker* w = walk->walkers + walk->of[k];
		walk->probes[k].pose.position = free_end(walk, k);
		walk->probes[k].translation = add_scaled(w->push, -dot(w->push, up), up);
	}
	TRY(cast(walk));
	for (int k = 0; k < walk->asked; ++k)
	{
		walk->probes[k].pose.position = free_end(walk, k);
		walk->probes[k].translation = add_scaled((scree_vec){0}, -(def->climb + 3.0f * def->skin), up);
	}
	TRY(cast(walk));
	TRY(find_ground(walk));
	for (int k = 0; k < walk->asked; ++k)
	{
		Walker* w = walk->walkers + walk->of[k];
		scree_vec end = free_end(walk, k), step = {end.x - w->at.x, end.y - w->at.y};
		scree_vec top = {walk->found[k].point.x - w->at.x, walk->found[k].point.y - w->at.y};
		float rises = dot(top, up) + 0.5f * def->length + def->radius + def->skin;
		if (walk->found[k].hit && rises <= def->climb + TOUCH &&
		    dot(step, w->push) > 0.5f * TOUCH * sqrtf(dot(w->push, w->push)))
		{
			w->at = end;
			w->ground = walk->found[k].collidable;
			w->normal = walk->found[k].normal;
			w->velocity = clip(w->kept, up);
			w->rest = (scree_vec){0.0f, 0.0f};
			w->wall = SCREE_NULL_COLLIDABLE;
			w->wall_normal = (scree_vec){0.0f, 0.0f};
		}
		w->push = (scree_vec){0.0f, 0.0f};
	}
	return SCREE_OK;
}

scree_status walk_slide(Walk* walk)
{
	for (int round = 0; round < SLIDE_ROUNDS; ++round)
	{
		walk->asked = 0;
		for (int k = 0; k < walk->count; ++k)
			if (dot(walk->walkers[k].rest, walk->walkers[k].rest) > 0.0f)
				ask(walk, k, walk->walkers[k].at, walk->walkers[k].rest);
		if (walk->asked == 0)
			break;
		TRY(cast(walk));
		for (int k = 0; k < walk->asked; ++k)
		{
			Walker* w = walk->walkers + walk->of[k];
			scree_vec end = free_end(walk, k);
			w->rest = walk->found[k].hit ? (scree_vec){w->at.x + w->rest.x - end.x, w->at.y + w->rest.y - end.y}
			                             : (scree_vec){0.0f, 0.0f};
			w->at = end;
			if (walk->found[k].hit)
				meet(walk, w, walk->found[k].collidable, walk->found[k].normal);
		}
		if (walk->def->climb > 0.0f)
			TRY(climb(walk));
	}
	return SCREE_OK;
}

scree_status walk_stand(Walk* walk)
{
	const scree_mover_def* def = walk->def;
	walk->asked = 0;
	for (int k = 0; k < walk->count; ++k)
	{
		const Walker* w = walk->walkers + k;
		float reach = 2.0f * def->skin + (w->stood ? def->snap : 0.0f);
		if (!w->crushed && dot(w->velocity, def->up) <= 0.0f && scree_collidable_is_null(w->ground))
			ask(walk, k, w->at, add_scaled((scree_vec){0}, -reach, def->up));
	}
	if (walk->asked == 0)
		return SCREE_OK;
	TRY(cast(walk));
	TRY(find_ground(walk));
	for (int k = 0; k < walk->asked; ++k)
	{
		if (!walk->found[k].hit)
			continue;
		Walker* w = walk->walkers + walk->of[k];
		w->at = free_end(walk, k);
		w->ground = walk->found[k].collidable;
		w->normal = walk->found[k].normal;
		w->velocity = clip(w->velocity, def->up);
	}
	return SCREE_OK;
}
