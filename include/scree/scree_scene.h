// SPDX-License-Identifier: MIT
// scree_scene.h -- the library scree_scene: loads scene files into worlds, steps them, and writes any world as a scene file.
//
// docs/manual/scenes.md has the format. The shortest program is examples/scene.c. Link scree_scene, scree and Jansson: the target
// scree::scene of CMake, or `pkg-config --libs scree_scene`.
//
// Functions fail as those of scree.h do: scree_error() has a sentence, which names file, place and value, and the hook of
// scree_fail_hook_set is called. Definitions and results have their sizes as there.
#ifndef SCREE_SCENE_H
#define SCREE_SCENE_H
#include "scree/scree.h"

#ifdef __cplusplus
extern "C" {
#endif

// A loaded scene: its world, and the parts of the file that a world does not have, such as names, keys and characters.
typedef struct scree_scene scree_scene;

typedef struct scree_scene_setting // value of a parameter of a scene, as --set NAME=VALUE of the command line
{
	const char* name;
	const char* value; // number, or expression without names
} scree_scene_setting;

typedef struct scree_scene_def
{
	uint32_t size; // set by scree_scene_def_default
	// Device, threads, lanes, tasks, allow_unequal_bits, timings, opengl, capacities, contact_limit, device_timeout and
	// recovery_interval of the world; its other members are those of the scene. null (default): scree_world_def_default.
	const scree_world_def* world;
	const scree_scene_setting* settings; // parameters; those that are not set have the defaults of the file
	int setting_count;                   // default 0
} scree_scene_def;

// Returns a definition with the default values.
static inline scree_scene_def scree_scene_def_default(void);

#define SCREE_SCENE_NAME  64  // bytes of a name in UTF-8, with the final 0; longer ones are cut between characters
#define SCREE_SCENE_TITLE 160 // bytes of a title, likewise

typedef struct scree_scene_info // settings of a scene that its world does not have
{
	uint32_t size; // set by scree_scene_info_default
	char name[SCREE_SCENE_NAME];
	char title[SCREE_SCENE_TITLE];
	float dt;                // s, 1e-5 to 1, default 1/60: length of a step
	int substeps;            // 1 to 64, default 4
	int steps;               // 1 to 1e9, default 300: length of a run
	float penetration_limit; // m, >= 0, default 0.05: a measurement with deeper overlaps is invalid
	bool has_view;           // true: the scene has a camera, the box `view`
	bool has_detail;         // true: `detail`, a part of the view, is shown magnified
	scree_box view, detail;  // m, at least 0.01 m wide and high
	// members of loaded scenes, which scree_scene_write does not read
	int body_count, collidable_count, joint_count; // numbers of objects at the start
	uint32_t keys;                                 // keys that the scene uses: bits of SCREE_SCENE_KEY_*
} scree_scene_info;

// Returns the default values, without a name.
static inline scree_scene_info scree_scene_info_default(void);

enum // keys of the keyboard, for scree_scene_set_keys
{
	SCREE_SCENE_KEY_LEFT = 1,
	SCREE_SCENE_KEY_RIGHT = 2,
	SCREE_SCENE_KEY_UP = 4,
	SCREE_SCENE_KEY_DOWN = 8,
	SCREE_SCENE_KEY_SPACE = 16,
	SCREE_SCENE_KEY_SHIFT = 32,
	SCREE_SCENE_KEY_ENTER = 64,
	SCREE_SCENE_KEY_A = 128,
	SCREE_SCENE_KEY_D = 256,
	SCREE_SCENE_KEY_S = 512,
	SCREE_SCENE_KEY_W = 1024,
};

// Reads a scene file and creates its world. def may be null. The caller owns *scene, and destroys it with scree_scene_destroy. On
// failure *scene is null. Fails with SCREE_ERROR_FILE if the file cannot be read, with SCREE_ERROR_INVALID if it is not a scene or
// def is out of range, and as scree_world_create.
SCREE_API scree_status scree_scene_load(const char* path, const scree_scene_def* def, scree_scene** scene);

// Loads a scene as scree_scene_load does, from the text of a file in memory, of `size` bytes. name: name of the file, for
// messages.
SCREE_API scree_status scree_scene_load_text(const void* text, size_t size, const char* name,
                                             const scree_scene_def* def, scree_scene** scene);

// Destroys a scene and its world. scene may be null.
SCREE_API void scree_scene_destroy(scree_scene* scene);

// Returns the world of a scene, which the scene owns; null if scene is null.
SCREE_API scree_world* scree_scene_get_world(const scree_scene* scene);

// Returns the settings of a scene.
static inline scree_status scree_scene_get_info(const scree_scene* scene, scree_scene_info* info);

// Writes up to capacity names of the entries of bodies that have one, in the order of the file, and sets count to their number.
// The scene owns the strings.
SCREE_API scree_status scree_scene_get_names(const scree_scene* scene, const char** names, int capacity, int* count);

// Writes the handles of up to capacity bodies of the entry with a name, as they were at the start, and sets count to their number.
// Those of destroyed bodies are stale. Fails with SCREE_ERROR_INVALID if no entry has the name.
SCREE_API scree_status scree_scene_get_bodies(const scree_scene* scene, const char* name, scree_body* bodies,
                                              int capacity, int* count);

// Sets the keys that the user holds: bits of SCREE_SCENE_KEY_*; none at first. Keys that the scene does not use have no effect.
SCREE_API scree_status scree_scene_set_keys(scree_scene* scene, uint32_t keys);

// Takes a step of the scene's world, with dt and substeps of the file. Before it, applies what the file has for this step:
// explosions, forces of keys, characters, and changes of bodies (churn). A program that needs none of these may call
// scree_world_step instead. Fails as scree_world_step.
SCREE_API scree_status scree_scene_step(scree_scene* scene);

// Writes a world as a scene file. info: settings of the file; null: defaults. A missing name is that of the file, a missing title
// the name. The file is complete or, on failure, as it was before. docs/manual/scenes.md lists what a scene file carries: the bodies,
// collidables, attributes, materials, paths, joints, exclusions and fields, with user data, poses and velocities as exact bits; not
// contacts, impulses, saves, or forces and targets that are pending.
//
// A world that has taken no step, whose objects were created in the order of a scene file and of which none was destroyed, has the
// hash of the loaded world.
//
// Fails with SCREE_ERROR_FILE if the file cannot be written, and with SCREE_ERROR_INVALID if a value is beyond those of scene
// files, such as a body beyond SCREE_MAX_COORDINATE, if a name or title is not UTF-8, if the file would have more than 64 MiB, the most that is loaded, or if
// the world has a length_unit other than 1. It fails as functions that read the world.
SCREE_API scree_status scree_scene_write(scree_world* world, const scree_scene_info* info, const char* path);

// Writes the same text to memory. *text gets the text, which ends with 0, and *size its bytes without that 0. The caller frees
// the text with scree_scene_free_text. On failure *text is null. name: name of the file, for messages.
SCREE_API scree_status scree_scene_write_text(scree_world* world, const scree_scene_info* info, const char* name,
                                              char** text, size_t* size);

// Frees a text of scree_scene_write_text. text may be null.
SCREE_API void scree_scene_free_text(char* text);

// ---------------------------------------------------------------------------------------------------------------
// Functions with the sizes of structs; programs call the functions above
// ---------------------------------------------------------------------------------------------------------------

SCREE_API void scree_scene_def_default_sized(scree_scene_def* def, size_t size);
static inline scree_scene_def scree_scene_def_default(void)
{
	scree_scene_def def;
	scree_scene_def_default_sized(&def, sizeof def);
	return def;
}

SCREE_API void scree_scene_info_default_sized(scree_scene_info* info, size_t size);
static inline scree_scene_info scree_scene_info_default(void)
{
	scree_scene_info info;
	scree_scene_info_default_sized(&info, sizeof info);
	return info;
}

SCREE_API scree_status scree_scene_get_info_sized(const scree_scene* scene, scree_scene_info* info, size_t size);
static inline scree_status scree_scene_get_info(const scree_scene* scene, scree_scene_info* info)
{
	return scree_scene_get_info_sized(scene, info, sizeof *info);
}

#ifdef __cplusplus
}
#endif
#endif
