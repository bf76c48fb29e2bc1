// SPDX-License-Identifier: MIT
// renderer.c -- draws a world from rows in an OpenGL buffer: bodies, and layers over them.
//
// A body with a reach below Style.detail is drawn as a splat: one vertex, which covers the body's pixels. A larger body
// is drawn as a rectangle whose fragments compute their signed distance from the shape. The shaders of splats discard
// the rows of larger bodies; the shaders of shapes discard the rows of splats.
#include "view/renderer.h"
#include "view/glsl.h"
#include "view/marker.h"
#include "view/opengl.h"
#include "view/paint_tables.h"
#include "view/scan_lines.h"
#include "view/theme.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define SUBSTEP (1.0f / 240.0f) // s: duration of a substep in worlds without a scene

bool renderer_open(Renderer* r, char* sentence)
{
	*r = (Renderer){0};
	const char* name = (const char*)glGetString(GL_RENDERER);
	r->software = name && (strstr(name, "llvmpipe") || strstr(name, "softpipe") || strstr(name, "SWR"));
	glGenVertexArrays(1, &r->one_each);
	glGenVertexArrays(1, &r->four_each);
	bool good = pass_open(&r->body, glsl_body_vert, glsl_body_frag, sentence) &&
	            pass_open(&r->splat, glsl_splat_vert, glsl_splat_frag, sentence) &&
	            pass_open(&r->box, glsl_box_vert, glsl_box_frag, sentence) &&
	            pass_open(&r->velocity, glsl_velocity_vert, glsl_stroke_frag, sentence) &&
	            pass_open(&r->center, glsl_center_vert, glsl_stroke_frag, sentence) &&
	            strokes_open(&r->strokes, sentence) && strokes_open(&r->under, sentence);
	if (!good)
		renderer_close(r);
	return good;
}

void renderer_close(Renderer* r)
{
	Pass* passes[] = {&r->body, &r->splat, &r->box, &r->velocity, &r->center};
	for (int k = 0; k < 5; ++k)
		pass_close(passes[k]);
	glDeleteVertexArrays(1, &r->one_each);
	glDeleteVertexArrays(1, &r->four_each);
	strokes_close(&r->strokes);
	strokes_close(&r->under);
	scan_close(&r->scan);
	flashes_close(&r->flashes);
	render_tables_close(&r->tables);
	joint_lines_close(&r->joint_lines);
	field_lines_close(&r->field_lines);
	free(r->contacts);
	*r = (Renderer){0};
}

bool renderer_update_world(Renderer* r, const Scene* scene, scree_world* world)
{
	r->contact_count = 0;
	r->lod = (Lod){0};
	r->scene = scene;
	scan_close(&r->scan);
	if (scene && scene->fan_count > 0 && scan_open(&r->scan, scene, world) != SCREE_OK)
		return false;
	return render_tables_build(&r->tables, scene, world) && joint_lines_build(&r->joint_lines, &r->tables);
}

static scree_status fetch_contacts(Renderer* r)
{
	scree_status status =
	    scree_world_get_contacts(r->tables.world, r->contacts, r->contact_capacity, &r->contact_count);
	if (status != SCREE_OK || r->contact_count <= r->contact_capacity)
		return status;
	int capacity = r->contact_count + r->contact_count / 2;
	scree_contact* contacts = realloc(r->contacts, (size_t)capacity * sizeof *contacts);
	r->contact_count = 0;
	if (!contacts)
		return SCREE_OK; // memory was short; the picture is drawn without contacts
	r->contacts = contacts;
	r->contact_capacity = capacity;
	return scree_world_get_contacts(r->tables.world, r->contacts, capacity, &r->contact_count);
}

static scree_status fetch_joints(Renderer* r)
{
	if (r->joint_lines.links.count == 0)
		return SCREE_OK;
	scree_status status = render_tables_update_bodies(&r->tables);
	return status == SCREE_OK ? joint_lines_update(&r->joint_lines, &r->tables) : status;
}

scree_status renderer_fetch(Renderer* r, const Camera* camera, const Style* style)
{
	// the bodies of a wall sleep as their worlds do, not as the template
	scree_status status = r->tiles.count > 0 ? SCREE_OK : paint_tables_fill_asleep(&r->tables);
	r->contact_count = 0;
	if (status != SCREE_OK)
		return status;
	if (style->paint == PAINT_SPEED || style->layers[LAYER_velocities])
		status = paint_tables_fill_velocities(&r->tables);
	if (status == SCREE_OK &&
	    (style->paint == PAINT_SOLVER || style->paint == PAINT_FORCE || style->layers[LAYER_contacts] ||
	     style->layers[LAYER_normals] || style->layers[LAYER_impulses]))
		status = fetch_contacts(r);
	if (status == SCREE_OK && style->paint == PAINT_SOLVER)
		paint_tables_fill_graph(&r->tables, r->contacts, r->contact_count);
	if (status == SCREE_OK && style->paint == PAINT_FORCE)
		paint_tables_fill_forces(&r->tables, r->contacts, r->contact_count,
		                         r->scene ? r->scene->dt / (float)r->scene->substeps : SUBSTEP);
	if (status == SCREE_OK && style->paint == PAINT_ORIGIN)
		status = paint_tables_fill_starts(&r->tables);
	if (status == SCREE_OK && style->layers[LAYER_joints])
		status = fetch_joints(r);
	if (status == SCREE_OK && style->layers[LAYER_fields])
		status = field_lines_update(&r->field_lines, &r->tables);
	if (status == SCREE_OK && style->layers[LAYER_rays] && r->scan.scene)
		status = scan_lines_update(&r->scan, r->tables.world, camera, style->rays);
	if (status == SCREE_OK && style->layers[LAYER_sensors])
		render_tables_update_sensors(&r->tables);
	return status;
}

scree_status renderer_step(Renderer* r, const Camera* camera, const Style* style, double now)
{
	r->tables.sensors.now = now;
	return flashes_step(&r->flashes, &r->tables, camera, style, now);
}

// Binds the rows, beginning with row `first`, as vertices (divisor 0) or as instances (divisor 1).
static void bind_rows(unsigned vertices, const Share* share, int first, GLuint divisor)
{
	const GLsizei row = sizeof(scree_render_row);
	const size_t begin = (size_t)first * sizeof(scree_render_row);
	glBindVertexArray(vertices);
	glBindBuffer(GL_ARRAY_BUFFER, share->buffer);
	glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, row, (void*)(begin + offsetof(scree_render_row, pose)));
	glVertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, row, (void*)(begin + offsetof(scree_render_row, center)));
	glVertexAttribIPointer(2, 2, GL_INT, row, (void*)(begin + offsetof(scree_render_row, attribute)));
	for (GLuint k = 0; k < 3; ++k)
	{
		glEnableVertexAttribArray(k);
		glVertexAttribDivisor(k, divisor);
	}
}

// Draws a layer over the bodies, with one instance per row, for `count` rows from row `first` on.
static void draw_over(const Renderer* r, const Pass* pass, const Share* share, int first, int count,
                      const Camera* camera, const Style* style)
{
	bind_rows(r->four_each, share, first, 1);
	pass_use(pass, &r->tables, camera, style);
	glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count);
}

static void begin_picture(const Camera* camera, const Style* style)
{
	Color background = theme_of(style->dark)->background;
	glViewport(0, 0, camera->width, camera->height);
	glDisable(GL_DEPTH_TEST);
	glDisable(GL_CULL_FACE);
	glDisable(GL_SCISSOR_TEST);
	glEnable(GL_BLEND);
	glBlendEquation(GL_FUNC_ADD);
	glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
	OPENGL_SHADERS_SIZE_POINTS();
	glClearColor((float)background.r / 255.0f, (float)background.g / 255.0f, (float)background.b / 255.0f, 1.0f);
	glClear(GL_COLOR_BUFFER_BIT);
}

// Draws bodies and layers of `count` rows from row `first` on, all of one world.
static void draw_rows(Renderer* r, const Share* share, int first, int count, const Camera* camera, const Style* style)
{
	pass_bind_tables(&r->tables);
	lod_update(&r->lod, &r->tables, count, camera->scale, style->detail);
	pass_use(&r->body, &r->tables, camera, style);
	for (int k = 0; k < r->lod.shape_runs; ++k)
	{
		bind_rows(r->four_each, share, first + r->lod.shapes[k].first, 1);
		glUniform1i(r->body.first, r->lod.shapes[k].first);
		glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, r->lod.shapes[k].count);
	}
	if (r->lod.splats)
	{
		bind_rows(r->one_each, share, first, 0);
		pass_use(&r->splat, &r->tables, camera, style);
		glDrawArrays(GL_POINTS, 0, count);
	}
	if (style->layers[LAYER_boxes])
		draw_over(r, &r->box, share, first, count, camera, style);
	if (style->layers[LAYER_velocities] && r->tiles.count == 0)
		draw_over(r, &r->velocity, share, first, count, camera, style);
	if (style->layers[LAYER_centers])
		draw_over(r, &r->center, share, first, count, camera, style);
}

// Draws all tiles of which a part is in the picture.
static void draw_tiles(Renderer* r, const Share* share, const Camera* camera, const Style* style)
{
	glEnable(GL_SCISSOR_TEST);
	for (int k = 0; k < r->tiles.count; ++k)
	{
		const scree_box* box = r->tiles.boxes + k;
		float x = 0.5f * (float)camera->width, y = 0.5f * (float)camera->height;
		float left = fmaxf(x + camera->scale * (box->lower.x - camera->middle.x), 0.0f);
		float right = fminf(x + camera->scale * (box->upper.x - camera->middle.x), (float)camera->width);
		float low = fmaxf(y + camera->scale * (box->lower.y - camera->middle.y), 0.0f);
		float high = fminf(y + camera->scale * (box->upper.y - camera->middle.y), (float)camera->height);
		if (left >= right || low >= high)
			continue;
		glScissor((GLint)left, (GLint)low, (GLsizei)ceilf(right - left), (GLsizei)ceilf(high - low));
		draw_rows(r, share, k * r->tiles.rows, r->tiles.rows, camera, style);
	}
	glDisable(GL_SCISSOR_TEST);
}

void renderer_draw(Renderer* r, const Share* share, const Camera* camera, const Style* style)
{
	begin_picture(camera, style);
	if (r->tiles.count > 0)
	{
		draw_tiles(r, share, camera, style);
		strokes_draw(&r->strokes, camera);
		return;
	}
	if (style->layers[LAYER_rays])
		scan_lines_mark(&r->scan, &r->under, &r->strokes, camera);
	strokes_draw(&r->under, camera);
	draw_rows(r, share, 0, share->count, camera, style);
	if (style->layers[LAYER_fields])
		field_lines_mark(&r->field_lines, &r->strokes);
	if (style->layers[LAYER_joints])
		joint_lines_mark(&r->joint_lines, r->tables.awake, &r->strokes, camera, style);
	flashes_mark(&r->flashes, &r->strokes, camera, r->tables.sensors.now);
	mark_contacts(&r->strokes, r->contacts, r->contact_count, camera, style, r->tables.size);
	strokes_draw(&r->strokes, camera);
}
