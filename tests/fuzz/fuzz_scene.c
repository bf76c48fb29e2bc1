// SPDX-License-Identifier: MIT
// fuzz_scene.c -- fuzz target: bytes are read as a scene file; if they are accepted, the scene runs for a few steps, and its world is
// written as a scene file, which is then accepted too.
//
// Work is limited, so that a repeat over millions of items does not take the time of thousands of other inputs.
#include "fuzz/fuzz.h"
#include "fuzz/mutate_json.h"
#include "scene/heading.h"
#include "scene/load.h"
#include "scene/player.h"
#include "scene/reader.h"
#include "scene/write_scene.h"
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#define MOST_WORK   200000              // operations of the reader
#define MOST_BODIES 500                 // also that of collidables, joints and rays of a scene that runs
#define MOST_MEMORY ((size_t)256 << 20) // bytes of a world
#define STEPS       3

// Writes bytes to a file in memory, and its path to `path`. Returns the descriptor.
static int open_bytes(const uint8_t* bytes, size_t size, char path[64])
{
	int file = memfd_create("scene", 0);
	FUZZ_CHECK(file >= 0 && write(file, bytes, size) == (ssize_t)size, "memfd_create");
	snprintf(path, 64, "/proc/self/fd/%d", file);
	return file;
}

static void check_sentence(const char* sentence, const char* path)
{
	FUZZ_CHECK(strncmp(sentence, path, strlen(path)) == 0 && strlen(sentence) > strlen(path) + 4, "\"%s\"", sentence);
	for (const char* c = sentence; *c; ++c)
		FUZZ_CHECK((unsigned char)*c >= ' ' && *c != 127, "a message has a control character");
}

static void write_again(const Scene* scene, scree_world* world)
{
	char sentence[SCENE_SENTENCE];
	Text text;
	if (scene_write(scene, world, "written", &text, sentence) == SCREE_OK)
	{
		reader_most_work = READER_WORK;
		Scene* again = scene_parse(text.bytes, text.used, "written", NULL, 0, sentence);
		FUZZ_CHECK(again, "a written scene is refused: %s", sentence);
		scene_free(again);
	}
	else if (*sentence)
		check_sentence(sentence, "written");
	text_free(&text);
}

static void run(const Scene* scene)
{
	ScenePlayer player;
	scree_world_def def = scene->world, limited = fuzz_world_def();
	def.device = limited.device;
	def.threads = limited.threads;
	def.lanes = limited.lanes;
	def.contact_limit = limited.contact_limit;
	scree_status status = player_open(&player, scene, &def);
	fuzz_check_status(status, "player_open");
	fuzz_accepted += status == SCREE_OK;
	player.down = player_keys(scene);
	for (int k = 0; k < STEPS && status == SCREE_OK; ++k)
	{
		status = player_step(&player);
		fuzz_check_status(status, "player_step");
		if (status == SCREE_OK)
			fuzz_check_status(player_scan(&player), "player_scan");
	}
	if (status == SCREE_OK)
	{
		fuzz_use_world(player.world, scene->dt, scene->substeps);
		write_again(scene, player.world);
	}
	player_close(&player);
}

int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size)
{
	char path[64], sentence[SCENE_SENTENCE] = "", title[64], parameters[64];
	int file = open_bytes(bytes, size, path);
	fuzz_limit_memory(MOST_MEMORY);
	reader_most_work = MOST_WORK;
	Scene* scene = scene_load(path, NULL, 0, sentence);
	if (!scene)
		check_sentence(sentence, path);
	else if (scene->body_count <= MOST_BODIES && scene->collidable_count <= MOST_BODIES &&
	         scene->joint_count <= MOST_BODIES && scene->ray_count <= MOST_BODIES)
		run(scene);
	scene_free(scene);
	scene_heading(path, title, sizeof title, parameters, sizeof parameters, sentence);
	scene_parameter_help(path, "a", title, sizeof title, sentence);
	close(file);
	FUZZ_CHECK(scree_memory() == 0, "%zu bytes of memory are not released", scree_memory());
	return 0;
}

FUZZ_MUTATOR(mutate_json, 8)
