// SPDX-License-Identifier: MIT
// draw_adapter.c -- draws a small world through an adapter of examples/draw/, in C or in C++, with a stand-in for its library.
//
// ADAPTER: name of the header. VIEW: call that returns its view, of 200 by 100 pixels with 10 pixels per m. PREPARE: declares
// the target that VIEW names.
#include ADAPTER
#include <stdio.h>

static bool add(scree_world* world, scree_body_type type, scree_shape shape, float x, float y)
{
	scree_attribute_def attribute = scree_attribute_def_default();
	scree_body_def body = scree_body_def_default();
	attribute.shape = shape;
	body.type = type;
	body.pose.position.x = x;
	body.pose.position.y = y;
	return scree_attribute_create(world, &attribute, &body.attribute) == SCREE_OK &&
	       scree_body_create(world, &body, NULL) == SCREE_OK;
}

int main(void)
{
	scree_world_def def = scree_world_def_default();
	scree_world* world;
	scree_shape box, disc, pill;
	scree_vec center = {0.0f, 0.0f}, a = {-1.0f, 0.0f}, b = {1.0f, 0.0f};
	def.device = "cpu";
	bool good = scree_world_create(&def, &world) == SCREE_OK && scree_shape_make_box(2.0f, 1.0f, &box) == SCREE_OK &&
	            scree_shape_make_circle(center, 1.0f, &disc) == SCREE_OK &&
	            scree_shape_make_capsule(a, b, 0.5f, &pill) == SCREE_OK &&
	            add(world, SCREE_BODY_STATIC, box, 0.0f, 0.0f) && add(world, SCREE_BODY_DYNAMIC, disc, 5.0f, 2.0f) &&
	            add(world, SCREE_BODY_DYNAMIC, pill, -5.0f, 2.0f) && add(world, SCREE_BODY_DYNAMIC, disc, 50.0f, 2.0f);
	PREPARE;
	DrawView view = VIEW;
	if (good && view_draw(world, &view, SCREE_DRAW_SHAPES | SCREE_DRAW_CENTERS | SCREE_DRAW_LABELS) == SCREE_OK)
	{
		scree_world_destroy(world);
		return 0;
	}
	fprintf(stderr, "%s\n", scree_error());
	return 1;
}
