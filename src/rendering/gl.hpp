#pragma once

// The functions of OpenGL beyond 1.1 are only declared where they are asked for.
#define GL_GLEXT_PROTOTYPES
#include <GL/glcorearb.h>
