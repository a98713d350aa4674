// Tests that trace are skipped without Embree, and say so.
#pragma once

#include <gtest/gtest.h>

#include "display/render/tracer.hpp"

#define NEEDS_EMBREE \
  if (!mmverify::render::has_embree()) GTEST_SKIP() << mmverify::render::embree_text()
