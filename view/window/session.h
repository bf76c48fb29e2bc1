// SPDX-License-Identifier: MIT
// session.h -- the scene that is on view: begun, stepped, paused, moved to another device.
#ifndef PLAY_H
#define PLAY_H
#include "view/window/view.h"

#define MAX_PARAMETERS 32
#define STAGES         6

typedef struct // of a scene
{
	char name[64], value[256];
} Parameter;

typedef struct
{
	const ViewOptions* options;
	const scree_opengl* opengl; // that worlds may share with, or null
	Scene* scene;
	scree_world* world;
	char name[SCENE_PATH]; // of the scene
	char** scenes;         // names of all
	int scene_count;
	Parameter parameters[MAX_PARAMETERS]; // of the scene, as the panel has them
	int parameter_count;
	scree_device* devices;
	int device_count;
	char device[160]; // asked for
	bool paused;
	float rate;    // seconds of the world a second of the clock, at most 1
	int64_t steps; // of the world, taken
	double owed;   // s: of the world, that the clock is ahead
	bool hashed;   // since the last step
	uint64_t hash; // of the world
	scree_counters counters;
	float step;           // ms, smoothed
	float stages[STAGES]; // ms, smoothed
} Play;

extern const char* const play_stages[STAGES];

// All but play_close return false after writing a sentence (SENTENCE of shader.h), and leave what there was.

// Lists scenes and devices, and begins the scene of the options.
bool play_open(Play* play, const ViewOptions* options, const scree_opengl* opengl, char* sentence);
void play_close(Play* play);

// Begins a scene: its parameters are those of the options if fresh, else those in parameters.
bool play_begin(Play* play, const char* name, bool fresh, char* sentence);

// Moves the world to another device.
bool play_move(Play* play, const char* device, char* sentence);

// Takes one step.
bool play_step(Play* play, char* sentence);

// The hash of the world as it is, into hash.
bool play_hash(Play* play, char* sentence);

#endif
