// SPDX-License-Identifier: MIT
// pass.c -- opens an OpenGL program that draws rows, and sets its uniforms from camera and style.
#include "view/pass.h"
#include "view/glsl.h"
#include "view/opengl.h"
#include "view/ramp.h"
#include "view/shader.h"
#include "view/theme.h"

#define TABLES 7 // number of textures with tables

static void write_color(Color color, float channels[3])
{
	channels[0] = (float)color.r / 255.0f;
	channels[1] = (float)color.g / 255.0f;
	channels[2] = (float)color.b / 255.0f;
}

static void set_color(int place, Color color)
{
	float channels[3];
	write_color(color, channels);
	glUniform3fv(place, 1, channels);
}

bool pass_open(Pass* pass, const char* vertex, const char* fragment, char* sentence)
{
	pass->program = shader_link(glsl_row_glsl, vertex, fragment, sentence);
	if (!pass->program)
		return false;
	const char* names[] = {"view",    "scale", "paint", "least", "size",  "line", "coarse", "first", "marked",
	                       "sensors", "ramp",  "types", "still", "glass", "ink",  "sleeps", "ground"};
	int* places[] = {&pass->view,   &pass->scale, &pass->paint,  &pass->least,   &pass->size,  &pass->line,
	                 &pass->coarse, &pass->first, &pass->marked, &pass->sensors, &pass->ramp,  &pass->types,
	                 &pass->still,  &pass->glass, &pass->ink,    &pass->sleeps,  &pass->ground};
	for (size_t k = 0; k < sizeof names / sizeof *names; ++k)
		*places[k] = glGetUniformLocation(pass->program, names[k]);
	const char* samplers[TABLES] = {"table", "kinds", "velocities", "graph", "marks", "shares", "asleep"};
	glUseProgram(pass->program);
	for (int k = 0; k < TABLES; ++k)
		glUniform1i(glGetUniformLocation(pass->program, samplers[k]), k);
	float palette[GRAPH_COLORS][3], types[2][3];
	for (int k = 0; k < GRAPH_COLORS; ++k)
		write_color(graph_color(k), palette[k]);
	for (int k = 0; k < 2; ++k)
		write_color(type_color(k ? SCREE_BODY_DYNAMIC : SCREE_BODY_KINEMATIC), types[k]);
	glUniform3fv(glGetUniformLocation(pass->program, "palette"), GRAPH_COLORS, palette[0]);
	glUniform3fv(pass->types, 2, types[0]);
	return true;
}

void pass_close(Pass* pass)
{
	glDeleteProgram(pass->program);
	*pass = (Pass){0};
}

static void set_colors(const Pass* pass, const Style* style)
{
	const Theme* theme = theme_of(style->dark);
	Color colors[RAMP_COLORS];
	float ramp[RAMP_COLORS][3];
	set_color(pass->still, theme->still);
	set_color(pass->glass, theme->glass);
	set_color(pass->ink, theme->ink);
	set_color(pass->ground, theme->background);
	if (!ramp_of(style->paint, colors))
		return;
	for (int k = 0; k < RAMP_COLORS; ++k)
		write_color(colors[k], ramp[k]);
	glUniform3fv(pass->ramp, RAMP_COLORS, ramp[0]);
}

void pass_use(const Pass* pass, const RenderTables* tables, const Camera* camera, const Style* style)
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
	glUniform1i(pass->marked, tables->sensors.rows);
	glUniform1i(pass->sleeps, tables->awake != NULL);
	glUniform1i(pass->sensors, style->layers[LAYER_sensors]);
	glUniform2f(pass->size, (float)camera->width, (float)camera->height);
	glUniform1f(pass->line, line < 0.7f ? 0.7f : line > 1.4f ? 1.4f : line);
	set_colors(pass, style);
}

void pass_bind_tables(const RenderTables* tables)
{
	const unsigned textures[TABLES] = {tables->attribute_texture.texture,
	                                   tables->kinds.texture,
	                                   tables->velocities.texture,
	                                   tables->graph.texture,
	                                   tables->marks.texture,
	                                   tables->shares.texture,
	                                   tables->asleep.texture};
	for (int k = 0; k < TABLES; ++k)
	{
		glActiveTexture((GLenum)(GL_TEXTURE0 + k));
		glBindTexture(GL_TEXTURE_2D, textures[k]);
	}
	glActiveTexture(GL_TEXTURE0);
}
