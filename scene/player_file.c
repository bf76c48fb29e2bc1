// SPDX-License-Identifier: MIT
// player_file.c -- writes and restores the state of a scene player: a snapshot with a chunk for its characters.
//
// scene.movers: the movers; scene.characters: words of CharacterState. A file of a program without scenes lacks both.
#include "scene/player_file.h"
#include "platform/error.h"
#include <string.h>

#define PARTS 2

static size_t mover_bytes(const ScenePlayer* player)
{
	return (size_t)player->scene->character_count * sizeof(scree_mover);
}

scree_status player_save(const ScenePlayer* player, const FilePart* more, int count, const void** bytes, size_t* size)
{
	const Characters* c = &player->characters;
	size_t movers = mover_bytes(player);
	FilePart parts[PARTS + PLAYER_MORE] = {
	    {"scene.movers", sizeof(scree_mover), c->movers, movers},
	    {"scene.characters", 4, &c->state, movers > 0 ? sizeof c->state : 0},
	};
	for (int k = 0; k < count; ++k)
		parts[PARTS + k] = more[k];
	return moment_write(player->world, parts, PARTS + count, bytes, size);
}

scree_status player_load(ScenePlayer* player, const void* bytes, size_t size, FilePart* more, int count)
{
	const Scene* scene = player->scene;
	Characters* c = &player->characters;
	scree_counters counters;
	FilePart parts[PARTS + PLAYER_MORE] = {{.name = "scene.movers", .unit = sizeof(scree_mover)},
	                                       {.name = "scene.characters", .unit = 4}};
	for (int k = 0; k < count; ++k)
		parts[PARTS + k] = more[k];
	TRY(moment_read(bytes, size, parts, PARTS + count));
	bool complete = parts[0].bytes == mover_bytes(player) && (parts[0].bytes == 0 || parts[1].bytes == sizeof c->state);
	if (!complete)
		return fail(SCREE_ERROR_INVALID, "the snapshot lacks the characters of the scene");
	TRY(scree_world_restore(player->world, bytes, size));
	TRY(scree_world_get_counters(player->world, &counters));
	if (counters.bodies < scene->body_count || counters.steps < 0 || counters.steps > INT32_MAX)
		return fail(SCREE_ERROR_DIFFERENT, "the snapshot has %d bodies and %lld steps, but the scene has %d bodies",
		            counters.bodies, (long long)counters.steps, scene->body_count);
	if (parts[0].bytes > 0)
	{
		memcpy(c->movers, parts[0].values, parts[0].bytes);
		memcpy(&c->state, parts[1].values, sizeof c->state);
	}
	player->steps = counters.steps;
	for (int k = 0; k < count; ++k)
		more[k] = parts[PARTS + k];
	return SCREE_OK;
}
