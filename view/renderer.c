// SPDX-License-Identifier: MIT
// renderer.c -- draws a world from rows in an OpenGL buffer: bodies, and layers over them.
//
// A body smaller than Style.detail is a splat: one vertex, and the pixels that it covers. A larger one is a rectangle whose
// fragments compute their signed distance from the shape. Each pass discards the rows of the other.
#include "view/renderer.h"
#include "view/glsl.h"
#include "view/marker.h"
#include "view/scan_lines.h"
#include "view/shader.h"
#include <epoxy/gl.h>
#include <stdlib.h>
#include <string.h>

static bool pass_open(Pass* pass, const char* vertex, const char* fragment, char* sentence)
{
	pass->program = shader_link(glsl_row_glsl, vertex, fragment, sentence);
	if (!pass->program)
		return false;
	const char* names[] = {"view", "scale", "paint", "least", "size", "line", "coarse", "first", "marked", "sensors"};
	int* places[] = {&pass->view, &pass->scale,  &pass->paint, &pass->least,  &pass->size,
	                 &pass->line, &pass->coarse, &pass->first, &pass->marked, &pass->sensors};
	for (int k = 0; k < 10; ++k)
		*places[k] = glGetUniformLocation(pass->program, names[k]);
	const char* samplers[] = {"table", "kinds", "velocities", "graph", "marks"};
	glUseProgram(pass->program);
	for (int k = 0; k < 5; ++k)
		glUniform1i(glGetUniformLocation(pass->program, samplers[k]), k);
	float palette[GRAPH_COLORS][3];
	for (int k = 0; k < GRAPH_COLORS; ++k)
	{
		Color color = graph_color(k);
		palette[k][0] = (float)color.r / 255.0f;
		palette[k][1] = (float)color.g / 255.0f;
		palette[k][2] = (float)color.b / 255.0f;
	}
	glUniform3fv(glGetUniformLocation(pass->program, "palette"), GRAPH_COLORS, palette[0]);
	return true;
}

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
	            strokes_open(&r->strokes, sentence) && strokes_open(&r->under, sentence);
	if (!good)
		renderer_close(r);
	return good;
}

void renderer_close(Renderer* r)
{
	Pass* passes[] = {&r->body, &r->splat, &r->box, &r->velocity};
	for (int k = 0; k < 4; ++k)
		glDeleteProgram(passes[k]->program);
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
		return SCREE_OK; // the picture is drawn without contacts
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
	scree_status status = SCREE_OK;
	r->contact_count = 0;
	if (style->paint == PAINT_SPEED || style->layers[LAYER_velocities])
		status = render_tables_update_velocities(&r->tables);
	if (status == SCREE_OK && (style->paint == PAINT_GRAPH || style->layers[LAYER_contacts] ||
	                           style->layers[LAYER_normals] || style->layers[LAYER_impulses]))
		status = fetch_contacts(r);
	if (status == SCREE_OK && style->paint == PAINT_GRAPH)
		render_tables_update_graph(&r->tables, r->contacts, r->contact_count);
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

// Binds the rows from first on, as vertices (divisor 0) or as instances (divisor 1).
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

static void use_pass(const Renderer* r, const Pass* pass, const Camera* camera, const Style* style)
{
	float line = 0.03f * camera->scale;
	glUseProgram(pass->program);
	glUniform4f(pass->view, camera->middle.x, camera->middle.y, 2.0f * camera->scale / (float)camera->width,
	            2.0f * camera->scale / (float)camera->height);
	glUniform1f(pass->scale, camera->scale);
	glUniform1i(pass->paint, (int)style->paint);
	glUniform1f(pass->least, style->detail);
	glUniform1i(pass->coarse, style->detail > 1.0f);
	glUniform1i(pass->first, 0);
	glUniform1i(pass->marked, r->tables.sensors.rows);
	glUniform1i(pass->sensors, style->layers[LAYER_sensors]);
	glUniform2f(pass->size, (float)camera->width, (float)camera->height);
	glUniform1f(pass->line, line < 0.7f ? 0.7f : line > 1.4f ? 1.4f : line);
}

static void bind_tables(const RenderTables* tables)
{
	const unsigned textures[] = {tables->attribute_texture.texture, tables->kinds.texture, tables->velocities.texture,
	                             tables->graph.texture, tables->marks.texture};
	for (int k = 0; k < 5; ++k)
	{
		glActiveTexture((GLenum)(GL_TEXTURE0 + k));
		glBindTexture(GL_TEXTURE_BUFFER, textures[k]);
	}
	glActiveTexture(GL_TEXTURE0);
}

// Draws a layer that has one instance for every row.
static void draw_over(const Renderer* r, const Pass* pass, const Share* share, const Camera* camera, const Style* style)
{
	bind_rows(r->four_each, share, 0, 1);
	use_pass(r, pass, camera, style);
	glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, share->count);
}

void renderer_draw(Renderer* r, const Share* share, const Camera* camera, const Style* style)
{
	Color background = BACKGROUND_COLOR;
	glViewport(0, 0, camera->width, camera->height);
	glDisable(GL_DEPTH_TEST);
	glDisable(GL_CULL_FACE);
	glDisable(GL_SCISSOR_TEST);
	glEnable(GL_BLEND);
	glBlendEquation(GL_FUNC_ADD);
	glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
	glEnable(GL_PROGRAM_POINT_SIZE);
	glClearColor((float)background.r / 255.0f, (float)background.g / 255.0f, (float)background.b / 255.0f, 1.0f);
	glClear(GL_COLOR_BUFFER_BIT);

	if (style->layers[LAYER_rays])
		scan_lines_mark(&r->scan, &r->under, &r->strokes, camera);
	strokes_draw(&r->under, camera);
	bind_tables(&r->tables);
	lod_update(&r->lod, &r->tables, share->count, camera->scale, style->detail);
	use_pass(r, &r->body, camera, style);
	for (int k = 0; k < r->lod.shape_runs; ++k)
	{
		bind_rows(r->four_each, share, r->lod.shapes[k].first, 1);
		glUniform1i(r->body.first, r->lod.shapes[k].first);
		glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, r->lod.shapes[k].count);
	}
	if (r->lod.splats)
	{
		bind_rows(r->one_each, share, 0, 0);
		use_pass(r, &r->splat, camera, style);
		glDrawArrays(GL_POINTS, 0, share->count);
	}
	if (style->layers[LAYER_boxes])
		draw_over(r, &r->box, share, camera, style);
	if (style->layers[LAYER_velocities])
		draw_over(r, &r->velocity, share, camera, style);
	if (style->layers[LAYER_fields])
		field_lines_mark(&r->field_lines, &r->strokes);
	if (style->layers[LAYER_joints])
		joint_lines_mark(&r->joint_lines, &r->strokes, camera, style->detail);
	flashes_mark(&r->flashes, &r->strokes, camera, r->tables.sensors.now);
	mark_contacts(&r->strokes, r->contacts, r->contact_count, camera, style);
	strokes_draw(&r->strokes, camera);
}
