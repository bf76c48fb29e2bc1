// SPDX-License-Identifier: MIT
// sprites.h -- lists the shapes and colors of a picture; uses only the public interface of Scree.
#ifndef SPRITES_H
#define SPRITES_H
#include "scene/shades.h"

// colors of the background and of the text of pictures
#define BACKGROUND_COLOR ((Color){247, 245, 240})
#define TEXT_COLOR       ((Color){70, 68, 64})

// color of a sensor: an outline, tinted while a collidable is inside; small sensors, such as coins, are filled
#define SENSOR_COLOR ((Color){38, 138, 94})
#define SENSOR_TINT  0.22f // opacity of the tint
#define COIN_TINT    0.55f // opacity of small sensors
#define COIN_REACH   16.0f // px: largest reach of a small sensor; body.vert uses the same numbers

#define CHARACTER_COLOR ((Color){196, 62, 40}) // color of the bodies that show characters; row.glsl uses the same

typedef struct // collidable to draw
{
	int body;        // index in Sprites.bodies; -1: without a body
	int attribute;   // index in Sprites.attributes
	scree_pose pose; // pose in the body's frame, or in the world if there is no body
	Color color;
	uint8_t shade;               // shade of the attribute
	bool sensor;                 // true: drawn as a sensor
	bool character;              // true: shows a character of the scene
	scree_collidable collidable; // may be destroyed, because a scene may replace bodies
} Sprite;

typedef struct
{
	scree_body* bodies;
	int body_count;
	Sprite* list; // in the order of drawing: sprites of bodies that are not dynamic, of dynamic bodies, of no body
	int count, capacity;
	int first_moving;
	scree_attribute_def* attributes; // definitions, by the index of the attribute's handle
	int* color_of;                   // entry of the palette (shades_of) for each attribute; -1: not assigned yet
	int attribute_count, colors;
} Sprites;

// Lists all collidables of a world. scene: the scene that filled the world; may be null. Returns false if memory is
// short.
bool sprites_list(Sprites* sprites, const Scene* scene, scree_world* world);
void sprites_free(Sprites* sprites);

// Returns the position of a body in Sprites.bodies, -1 if the list does not contain it.
int sprites_find(const Sprites* sprites, scree_body body);

// Returns true if a collidable was inside a sensor at the end of the last step.
bool sensor_visited(scree_world* world, scree_collidable sensor);

// Returns the pose of a sprite in the world. poses: poses of Sprites.bodies.
scree_pose sprite_pose(const Sprite* sprite, const scree_pose* poses);

#endif
