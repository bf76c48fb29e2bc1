// SPDX-License-Identifier: MIT
// run_query.c -- makes the queries and blasts of a program and moves its movers, with the same results in both worlds.
#include "programs/run_call.h"
#include <math.h>

#define APPROVAL 12

static float spread(uint32_t* seed, float size) { return size * (2.0f * call_random_part(seed) - 1.0f); }

static uint64_t mix_results(uint64_t word, const scree_query_result* results, int count)
{
	for (int k = 0; k < count; ++k)
	{
		const scree_query_result* r = results + k;
		int marks[] = {r->hit, r->inside, r->reserved};
		word = hash_words(hash_words(word, r, offsetof(scree_query_result, hit)), marks, sizeof marks);
	}
	return word;
}

static uint64_t mix_moved(uint64_t word, const scree_moved_body* m)
{
	word = hash_words(hash_words(word, &m->body, sizeof m->body), &m->pose, sizeof m->pose);
	return mix_user(hash_words(word, &m->velocity, sizeof m->velocity), m->user, m->asleep);
}

static scree_status mix_list(scree_status status, const scree_query_results* list, uint64_t* word)
{
	if (status == SCREE_OK)
		*word = mix_results(*word, list->results, list->count);
	return status;
}

scree_status run_ask(const CallRun* r)
{
	uint32_t seed = (uint32_t)call_whole(r, "seed");
	scree_vec center = call_vec(r, "x", "y");
	float size = call_real(r, "size");
	int attribute = call_whole(r, "attribute"), body = call_whole(r, "body");
	scree_query_def def = scree_query_def_default();
	def.kinds = (uint32_t)call_whole(r, "kinds");
	def.mask = (uint64_t)call_whole(r, "mask");
	scree_attribute_def surface = scree_attribute_def_default();
	bool shaped = attribute >= 0 && attribute < MOST_NAMES &&
	              scree_attribute_get_def(r->world, r->names->attributes[attribute], &surface) == SCREE_OK;
	const scree_shape* shape = shaped ? &surface.shape : NULL;
	scree_ray rays[APPROVAL];
	scree_probe probes[APPROVAL], places[APPROVAL];
	scree_query_result found[APPROVAL];
	scree_query_results list;
	for (int k = 0; k < APPROVAL; ++k)
	{
		float x = spread(&seed, size), y = spread(&seed, size), path_x = spread(&seed, size);
		scree_vec at = {center.x + x, center.y + y}, path = {path_x, k % 4 ? spread(&seed, size) : 0.0f};
		scree_body ignored = k % 3 ? SCREE_NULL_BODY : call_body(r, body);
		rays[k] = (scree_ray){.origin = at, .translation = path, .radius = k % 2 ? 0.0f : fabsf(0.1f * size)};
		rays[k].ignored = ignored;
		places[k] = (scree_probe){.pose = {at, scree_rot_make(spread(&seed, 3.0f))}, .ignored = ignored};
		probes[k] = places[k];
		probes[k].translation = path;
	}
	uint64_t word = 0;
	scree_status status = scree_world_cast_rays(r->world, &def, rays, APPROVAL, found);
	if (status == SCREE_OK)
	{
		word = mix_results(word, found, APPROVAL);
		status = scree_world_cast_shapes(r->world, &def, shape, probes, APPROVAL, found);
	}
	if (status == SCREE_OK)
	{
		word = mix_results(word, found, APPROVAL);
		status = scree_world_find_nearest(r->world, &def, shape, places, APPROVAL, fabsf(size), found);
	}
	if (status == SCREE_OK)
	{
		word = mix_results(word, found, APPROVAL);
		status = mix_list(scree_world_list_rays(r->world, &def, rays, APPROVAL, &list), &list, &word);
	}
	if (status == SCREE_OK)
		status = mix_list(scree_world_list_shapes(r->world, &def, shape, places, APPROVAL, &list), &list, &word);
	scree_moved_bodies moved = {0};
	if (status == SCREE_OK)
		status = scree_world_get_moved_bodies(r->world, &moved);
	for (int k = 0; k < moved.count && status == SCREE_OK; ++k)
		word = mix_moved(word, moved.bodies + k);
	r->left->word = word;
	return status;
}

scree_status run_blast(const CallRun* r)
{
	scree_blast_def def = scree_blast_def_default();
	def.position = call_vec(r, "x", "y");
	def.radius = call_real(r, "radius");
	def.falloff = call_real(r, "falloff");
	def.impulse = call_real(r, "impulse");
	def.mask = (uint64_t)call_whole(r, "mask");
	int count = 0;
	scree_status status = scree_world_blast(r->world, &def, &count);
	r->left->word = (uint64_t)count;
	return status;
}

scree_status run_walk(const CallRun* r)
{
	scree_mover_def def = scree_mover_def_default();
	def.radius = call_real(r, "radius");
	def.mask = (uint64_t)call_whole(r, "mask");
	scree_mover mover = {.position = call_vec(r, "x", "y"), .velocity = call_vec(r, "vx", "vy")};
	scree_body body = call_body(r, call_whole(r, "body"));
	scree_status status =
	    scree_movers_move_bodies(r->world, &def, &mover, &body, 1, call_real(r, "force"), call_real(r, "dt"));
	r->left->word = hash_bytes(HASH_BEGIN, &mover, sizeof mover);
	return status;
}
