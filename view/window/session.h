// SPDX-License-Identifier: MIT
// session.h -- the scene in the viewer: loaded, stepped, paused, moved to another device.
#ifndef SESSION_H
#define SESSION_H
#include "scene/character_motion.h"
#include "view/window/live_tuning.h"
#include "view/window/view_options.h"

#define MAX_PARAMETERS 32
#define STAGES         6

typedef struct // of a scene
{
	char name[64], value[256];
	char help[200]; // what it means
} Parameter;

typedef struct
{
	const ViewOptions* options;
	const scree_opengl* opengl; // that worlds may share with, or null
	Scene* scene;
	scree_world* world;
	Walkers walkers;       // characters of the scene
	char name[SCENE_PATH]; // of the scene
	char** scenes;         // names of all
	char (*titles)[160];   // of them; empty until they are asked for
	int scene_count;
	Parameter parameters[MAX_PARAMETERS]; // of the scene, as the panel has them
	int parameter_count;
	scree_device* devices;
	int device_count;
	char device[160]; // that the user chose
	bool paused;
	int due;            // steps that the user asked for one by one
	Tuning tuning;      // of the world
	float rate;         // seconds of the world a second of the clock, at most 1
	int64_t steps;      // of the world, so far
	double accumulator; // s of the world that the steps are behind the clock
	uint32_t down;      // keys that the scene asked for, and that the user holds down: bits by SceneKey
	bool hashed;        // hash is of the current state
	uint64_t hash;      // of the world
	scree_counters counters;
	float deepest;        // m: the deepest overlap since the world was made
	float last;           // ms: the last step
	float step;           // ms, smoothed
	float stages[STAGES]; // ms, smoothed
} Session;

extern const char* const session_stages[STAGES];

// On failure all but session_close write a sentence (SENTENCE of shader.h), return false and change nothing else.

// Lists scenes and devices, and loads the scene of the options.
bool session_open(Session* session, const ViewOptions* options, const scree_opengl* opengl, char* sentence);
void session_close(Session* session);

// Loads a scene and makes its world. fresh: with the parameters of the options, else with those in parameters.
bool session_load(Session* session, const char* name, bool fresh, char* sentence);

// The title of scene k of the list, read from its file when it is asked for first.
const char* session_title(Session* session, int k);

// Moves the world to another device.
bool session_move(Session* session, const char* device, char* sentence);

// Takes one step.
bool session_step(Session* session, char* sentence);

// Computes the hash of the current state.
bool session_hash(Session* session, char* sentence);

#endif
