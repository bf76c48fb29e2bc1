// SPDX-License-Identifier: MIT
// sprites.h -- the shapes and colors of a picture, read through the public interface of Scree.
#ifndef SPRITES_H
#define SPRITES_H
#include "scene/shades.h"

// colors of the background of pictures, and of their text
#define BACKGROUND_COLOR ((Color){247, 245, 240})
#define TEXT_COLOR       ((Color){70, 68, 64})

// color of sensors, which are outlines, tinted while something is inside
#define SENSOR_COLOR ((Color){38, 138, 94})
#define SENSOR_TINT  0.22f // opacity of the tint

typedef struct // one collidable that is drawn
{
	int body;        // index in Sprites.bodies, -1 for none
	int attribute;   // index in Sprites.attributes
	scree_pose pose; // in the body's frame; without a body in the world
	Color color;
	uint8_t shade;               // shade of the attribute
	bool sensor;                 // drawn as an outline
	scree_collidable collidable; // a scene may have replaced it since
} Sprite;

typedef struct
{
	scree_body* bodies;
	int body_count;
	Sprite* list; // from back to front: bodies that are not dynamic, dynamic ones, collidables without a body
	int count, capacity;
	int first_moving;
	scree_attribute_def* attributes; // by the index of their handles
	int* color_of;                   // entry of the palette, see shades_of; by attribute, -1 until one is assigned
	int attribute_count, colors;
} Sprites;

// Lists all collidables of a world and the scene that created it, or none (null). Returns false if memory is short.
bool sprites_list(Sprites* sprites, const Scene* scene, scree_world* world);
void sprites_free(Sprites* sprites);

// Returns the position of a body in Sprites.bodies, -1 if it is not there.
int sprites_find(const Sprites* sprites, scree_body body);

// Returns true if something was inside a sensor at the end of the last step.
bool sensor_visited(scree_world* world, scree_collidable sensor);

// Returns the pose of a sprite in the world; poses are those of Sprites.bodies.
scree_pose sprite_pose(const Sprite* sprite, const scree_pose* poses);

#endif
