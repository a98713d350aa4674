// Embree's functions, from its shared library, which is opened at the first use: without it the program starts, too.
#pragma once

#include <embree3/rtcore.h>

#include <string>

namespace mmverify::render {

/// The functions of Embree that a Tracer calls.
#define MMVERIFY_EMBREE_FUNCTIONS(X)       \
  X(rtcAttachGeometryByID)                 \
  X(rtcCommitGeometry)                     \
  X(rtcGetDeviceError)                     \
  X(rtcIntersect1)                         \
  X(rtcJoinCommitScene)                    \
  X(rtcNewDevice)                          \
  X(rtcNewGeometry)                        \
  X(rtcNewScene)                           \
  X(rtcOccluded1)                          \
  X(rtcReleaseDevice)                      \
  X(rtcReleaseGeometry)                    \
  X(rtcReleaseScene)                       \
  X(rtcSetGeometryInstancedScene)          \
  X(rtcSetGeometryIntersectFilterFunction) \
  X(rtcSetGeometryMask)                    \
  X(rtcSetGeometryOccludedFilterFunction)  \
  X(rtcSetGeometryTransform)               \
  X(rtcSetGeometryUserData)                \
  X(rtcSetNewGeometryBuffer)               \
  X(rtcSetSceneFlags)

/// These names, in this namespace, are pointers to the library's functions.  Domain: why_no_embree() is empty.
#define MMVERIFY_EMBREE_POINTER(name) extern decltype(&::name) name;
MMVERIFY_EMBREE_FUNCTIONS(MMVERIFY_EMBREE_POINTER)
#undef MMVERIFY_EMBREE_POINTER

/// Opens the library, once.  Returns the linker's message and what would help if that fails; else an empty text.
const std::string& why_no_embree();

}  // namespace mmverify::render
