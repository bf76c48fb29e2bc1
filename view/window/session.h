// SPDX-License-Identifier: MIT
// session.h -- the scene in the viewer: loads, steps, pauses it, moves it to another device.
#ifndef SESSION_H
#define SESSION_H
#include "scene/player.h"
#include "scene/stage_times.h"
#include "view/window/live_tuning.h"
#include "view/window/view_options.h"

#define MAX_PARAMETERS 32

typedef struct // parameter of a scene
{
	char name[64], value[256];
	char help[200]; // description
} Parameter;

typedef struct
{
	const ViewOptions* options;
	const scree_opengl* opengl; // context with which worlds may share memory, or null
	Scene* scene;
	ScenePlayer player;
	char name[SCENE_PATH]; // name of the scene
	char** scenes;         // names of all scenes
	char (*titles)[160];   // titles of all scenes; empty until first used
	int scene_count;
	Parameter parameters[MAX_PARAMETERS]; // parameters of the scene, as in the panel
	int parameter_count;
	scree_device* devices;
	int device_count;
	char device[160]; // device that the user selected
	bool paused;
	int due;            // single steps that the user requested and that are not yet taken
	Tuning tuning;      // parameters of the world
	float rate;         // simulated seconds per second of the clock, at most 1
	double accumulator; // s of simulated time by which the steps lag behind the clock
	bool hashed;        // true if hash belongs to the current state
	uint64_t hash;      // hash of the world
	scree_counters counters;
	float deepest;             // m: the deepest overlap since the world was created
	float last;                // ms: duration of the last step
	float step;                // ms: duration of a step, smoothed
	float stages[STAGE_TIMES]; // ms: durations of the stages, smoothed
} Session;

// On failure all functions except session_close write a sentence (SENTENCE of shader.h), return false and change
// nothing else.

// Lists scenes and devices, and loads the scene of the options.
bool session_open(Session* session, const ViewOptions* options, const scree_opengl* opengl, char* sentence);
void session_close(Session* session);

// Loads a scene and creates its world. fresh: with the parameters of the options, else with the current ones.
bool session_load(Session* session, const char* name, bool fresh, char* sentence);

// Returns the title of scene k of the list; reads it from its file at the first call.
const char* session_title(Session* session, int k);

// Moves the world to another device.
bool session_move(Session* session, const char* device, char* sentence);

// Takes one step.
bool session_step(Session* session, char* sentence);

// Computes the hash of the current state.
bool session_hash(Session* session, char* sentence);

#endif
