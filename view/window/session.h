// SPDX-License-Identifier: MIT
// session.h -- the scene or recording in the viewer: loads and steps it, and moves it to another device.
#ifndef SESSION_H
#define SESSION_H
#include "scene/player.h"
#include "scene/stage_times.h"
#include "view/window/live_tuning.h"
#include "view/window/playback.h"
#include "view/window/view_options.h"

#define MAX_PARAMETERS 32

typedef struct // parameter of a scene
{
	char name[64], value[256];
	char help[200]; // description of the parameter, for its tooltip
} Parameter;

typedef struct
{
	const ViewOptions* options;
	const scree_opengl* opengl; // context with which worlds may share memory, or null
	Scene* scene;
	ScenePlayer player;
	Playback playback;     // replay of a recording; the scene then has no bodies
	char name[SCENE_PATH]; // name of the scene, or path of the recording
	char** scenes;         // names of all scenes
	char (*titles)[160];   // titles of all scenes; a title is empty until session_title reads it
	int scene_count;
	Parameter parameters[MAX_PARAMETERS]; // parameters of the scene, with the values in the panel
	int parameter_count;
	scree_device* devices;
	int device_count;
	char device[160]; // device that the user selected, or "auto"
	bool paused;
	int due;            // number of single steps that the user has requested and the world has not yet taken
	Tuning tuning;      // gravity, substeps and solver tuning
	float rate;         // simulated seconds per second of real time; at most 1
	double accumulator; // s: simulated time by which the world lags behind the clock
	double seconds;     // s: simulated time of all steps that were taken, those before the user went back included
	bool hashed;        // true if Session.hash belongs to the current state
	uint64_t hash;      // hash of the world when session_hash was called
	scree_counters counters;
	float deepest;             // m: depth of the deepest overlap since the world was created
	float last;                // ms: duration of the last step
	float step;                // ms: duration of a step, smoothed
	float stages[STAGE_TIMES]; // ms: durations of the stages, smoothed
} Session;

// Functions that return bool write a sentence (SENTENCE of shader.h) and return false on failure. If session_load or
// session_move fails, the session does not change.

// Lists scenes and devices, and loads the scene or recording that the options name.
bool session_open(Session* session, const ViewOptions* options, const scree_opengl* opengl, char* sentence);
void session_close(Session* session);

// Loads a scene or a recording and creates its world. fresh: true for the parameters of the options, false for those of the
// panel.
bool session_load(Session* session, const char* name, bool fresh, char* sentence);

// Returns the title of scene k in the list. The first call for a scene reads its file.
const char* session_title(Session* session, int k);

// Moves the world to another device.
bool session_move(Session* session, const char* device, char* sentence);

// Returns true if the viewer shows a recording, whose steps are repeated.
bool session_replays(const Session* session);

// Takes one step, unless a recording has ended (Playback.ended).
bool session_step(Session* session, char* sentence);

// Computes the hash of the current state, and sets Session.hash and Session.hashed.
bool session_hash(Session* session, char* sentence);

#endif
