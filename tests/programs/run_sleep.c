// SPDX-License-Identifier: MIT
// run_sleep.c -- makes the calls of sleep, and reads which bodies sleep.
#include "programs/run_call.h"

static scree_status set_awake(const CallRun* r)
{
	scree_body bodies[MOST_BATCH];
	bool awake[MOST_BATCH];
	int first = call_whole(r, "body"), count = call_batch(r, "body");
	if (call_whole(r, "count") == 0)
		return scree_body_set_awake(r->world, call_body(r, first), call_whole(r, "awake") != 0);
	for (int k = 0; k < count; ++k)
	{
		bodies[k] = call_body(r, first + k);
		awake[k] = call_whole(r, "awake") != 0;
	}
	return scree_bodies_set_awake(r->world, bodies, awake, count);
}

static scree_status set_box_awake(const CallRun* r)
{
	scree_vec center = call_vec(r, "x", "y"), size = call_vec(r, "width", "height");
	scree_box box = {{center.x - 0.5f * size.x, center.y - 0.5f * size.y},
	                 {center.x + 0.5f * size.x, center.y + 0.5f * size.y}};
	return scree_world_set_box_awake(r->world, box, call_whole(r, "awake") != 0);
}

static scree_status get_awake(const CallRun* r)
{
	scree_body bodies[MOST_BATCH];
	bool awake[MOST_BATCH] = {false};
	int first = call_whole(r, "body"), count = call_batch(r, "body");
	scree_status status;
	for (int k = 0; k < count; ++k)
		bodies[k] = call_body(r, first + k);
	if (call_whole(r, "count") == 0)
		status = scree_body_get_awake(r->world, call_body(r, first), awake);
	else
		status = scree_bodies_get_awake(r->world, bodies, awake, count);
	r->left->word = HASH_BEGIN;
	for (int k = 0; k < (count > 0 ? count : 1) && status == SCREE_OK; ++k)
	{
		int value = awake[k];
		r->left->word = hash_words(r->left->word, &value, sizeof value);
	}
	return status;
}

scree_status read_sleep(const CallRun* r, scree_body body, uint64_t* word)
{
	enum
	{
		MOST = 512
	};
	static scree_body_state states[MOST];
	int count = 0;
	scree_status status = scree_world_get_states(r->world, NULL, states, MOST, &count);
	for (int k = 0; k < count && k < MOST && status == SCREE_OK; ++k)
	{
		int asleep = states[k].asleep;
		*word = hash_words(hash_words(*word, &states[k].pose, sizeof states[k].pose), &asleep, sizeof asleep);
	}
	if (status != SCREE_OK || !scree_body_is_valid(r->world, body))
		return status;
	scree_body_def def;
	float threshold = 0.0f;
	bool stays = false, awake = false;
	status = scree_body_get_def(r->world, body, &def);
	if (status == SCREE_OK)
		status = scree_body_get_sleep_threshold(r->world, body, &threshold);
	if (status == SCREE_OK)
		status = scree_body_get_stays_awake(r->world, body, &stays);
	if (status == SCREE_OK)
		status = scree_body_get_awake(r->world, body, &awake);
	if (status != SCREE_OK)
		return status;
	int flags[] = {def.asleep, def.stays_awake, stays, awake};
	float thresholds[] = {def.sleep_threshold, threshold};
	*word = hash_words(hash_words(*word, flags, sizeof flags), thresholds, sizeof thresholds);
	return def.asleep == awake ? SCREE_ERROR_DEVICE_FAILED : SCREE_OK;
}

scree_status run_sleep(const CallRun* r)
{
	scree_body body = {0, 0};
	switch (r->call->kind)
	{
	case CALL_awake:
		return set_awake(r);
	case CALL_awake_box:
		return set_box_awake(r);
	case CALL_awake_world:
		return scree_world_set_awake(r->world, call_whole(r, "awake") != 0);
	case CALL_sleep_threshold:
		body = call_body(r, call_whole(r, "body"));
		return scree_body_set_sleep_threshold(r->world, body, call_real(r, "speed"));
	case CALL_stays_awake:
		body = call_body(r, call_whole(r, "body"));
		return scree_body_set_stays_awake(r->world, body, call_whole(r, "stays") != 0);
	default:
		return get_awake(r);
	}
}
