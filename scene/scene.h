// SPDX-License-Identifier: MIT
// scene.h -- scene files: read and checked as a whole, then built into a world.
//
// docs: scenes/scene.schema.json describes the format.
#ifndef SCENE_H
#define SCENE_H
#include "scree/scree.h"
#include <stdio.h>

#define SCENE_MAX_BODIES 20000000
#define SCENE_SENTENCE   512
#define SCENE_PATH       1024

typedef struct Block Block;         // a set of like bodies or collidables, scene/block.h
typedef struct Attribute Attribute; // scene/attributes.h

typedef struct
{
	char name[64];
	char title[160];
	scree_world_def world; // device, threads and lanes are the caller's to set
	float dt;              // s
	int substeps;
	int steps;               // how long the scene is worth running
	float penetration_limit; // m: deeper overlaps than this show that something is wrong
	bool has_view;
	scree_box view; // m: what a picture shows
	int body_count, collidable_count;

	uint64_t seed;
	Attribute* attributes;
	int attribute_count;
	Block* blocks; // of bodies, then of collidables without a body
	int block_count;
} Scene;

typedef struct // --set NAME=VALUE
{
	const char* name;
	const char* value; // a number or an expression without names
} SceneSetting;

// Reads and checks a whole file. Returns null and writes a sentence (SCENE_SENTENCE characters) when anything in it is
// wrong. The caller frees the scene.
Scene* scene_load(const char* path, const SceneSetting* settings, int count, char* sentence);
void scene_free(Scene* scene);

// Puts a scene into an empty world. On failure scree_error() says why, and the world is to be destroyed.
scree_status scene_build(const Scene* scene, scree_world* world);

// Does to the bodies of a world what the scene does to them before a step, the first being number 0: some are put
// elsewhere, some destroyed and made anew. The world holds what scene_build put there, and has been through all steps
// before this one; what was added later stays as it is. On failure scree_error() says why.
scree_status scene_churn(const Scene* scene, scree_world* world, int64_t step);

// Whether scene_churn does anything.
bool scene_churns(const Scene* scene);

// What scene_churn does to one body of the scene, for those who hold it in another form than a world.
typedef struct
{
	int item;      // number of the body in the order of the file
	bool replaced; // destroyed and made anew; else put elsewhere
	scree_body_def
	    body; // where it goes on, and for one made anew all else, attribute as a position in Scene.attributes
} SceneChange;

// Writes the changes before a step, in rising order of replaced and of item within each block, into *changes, which the
// caller frees, and returns how many there are; -1 when there is no memory.
int scene_changes(const Scene* scene, int64_t step, SceneChange** changes);

// Finds the file of a scene: a path if it has a slash or ends in .json, else a name looked for in $SCREE_SCENES, the
// folders known at build time, and beside the executable (may be null). path has SCENE_PATH characters. Returns false
// and writes a sentence when there is none.
bool scene_find(const char* name, const char* executable, char* path, char* sentence);

// Lists the names of the scenes in all of these folders, sorted, into *names (free each, then the list). Returns how
// many there are; where there are none, sentence says why.
int scene_list(const char* executable, char*** names, char* sentence);

// Writes the title and the parameters with their defaults ("rows=100 columns=20") of a scene file.
bool scene_heading(const char* path, char* title, size_t title_size, char* parameters, size_t parameters_size,
                   char* sentence);

#endif
