// SPDX-License-Identifier: MIT
// player_file.h -- writes and restores the state of a scene player: a snapshot with a chunk for its characters.
#ifndef PLAYER_FILE_H
#define PLAYER_FILE_H
#include "scene/moment_file.h"
#include "scene/player.h"

#define PLAYER_MORE 4 // largest number of parts of a caller

// Writes the state of a player, with parts of the caller. *bytes is memory of the world, valid until its next snapshot.
scree_status player_save(const ScenePlayer* player, const FilePart* more, int count, const void** bytes, size_t* size);

// Restores a player of the same scene, and finds parts of the caller. Fails as scree_world_restore, also if the file lacks the
// characters of the scene. Fails with SCREE_ERROR_DIFFERENT if the snapshot has fewer bodies than the scene, as one of another
// scene may have; the world is then restored, but cannot be used with the scene.
scree_status player_load(ScenePlayer* player, const void* bytes, size_t size, FilePart* more, int count);

#endif
