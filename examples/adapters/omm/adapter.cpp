// NVIDIA's Opacity Micro-Map SDK as a subject: ommCpuBake is judged as a baker.  Opaque is alpha > cutoff,
// and mixed micro-triangles are UO.  States count as right within 8 bits of a texel's fraction.
#include <omm.h>

#include "examples/adapters/subject.hpp"

static ommBaker baker = nullptr;

static ommCpuTexture texture(const mmverify_bake_case_t& c) {
  static thread_local ommCpuTexture made = nullptr;
  if (same_texture_as_before(c)) return made;
  if (made != nullptr) ommCpuDestroyTexture(baker, made);
  std::vector<ommCpuTextureMipDesc> mips;
  each_mip(c, [&](uint32_t w, uint32_t h, const uint8_t* texels) { mips.push_back({w, h, w, texels}); });
  const ommCpuTextureDesc desc = {ommCpuTextureFormat_UNORM8, {}, mips.data(), c.mips, -1};
  made = nullptr;
  return ommCpuCreateTexture(baker, &desc, &made) == ommResult_SUCCESS ? made : nullptr;
}

static int bake(const mmverify_bake_case_t* c, uint8_t* map) {
  const uint32_t corners[] = {0, 1, 2};
  ommCpuBakeInputDesc in = ommCpuBakeInputDescDefault();
  in.texture = texture(*c), in.texCoords = c->uv, in.indexBuffer = corners, in.indexCount = 3;
  in.bakeFlags = ommCpuBakeFlags_Force32BitIndices, in.alphaMode = ommAlphaMode_Test;
  in.alphaCutoff = float(double(c->cutoff_numerator) / c->cutoff_denominator);
  in.runtimeSamplerDesc = {ommTextureAddressMode(c->wrap_u), ommTextureFilterMode_Linear,
                           float(c->border) / 255};
  in.texCoordFormat = ommTexCoordFormat_UV32_FLOAT, in.indexFormat = ommIndexFormat_UINT_32;
  in.dynamicSubdivisionScale = 0, in.maxSubdivisionLevel = uint8_t(c->level),
  in.format = ommFormat(c->format);
  ommCpuBakeResult result = nullptr;
  const ommCpuBakeResultDesc* out = nullptr;
  if (in.texture == nullptr || ommCpuBake(baker, &in, &result) != ommResult_SUCCESS) return 0;
  ommCpuGetBakeResultDesc(result, &out);
  const int32_t index = *static_cast<const int32_t*>(out->indexBuffer);
  if (index < 0)
    uniform(*c, -1 - index, map);
  else {
    const char* const data = static_cast<const char*>(out->arrayData) + out->descArray[index].offset;
    std::memcpy(map, data, bytes_of(*c));
  }
  ommCpuDestroyBakeResult(result);
  return 1;
}

extern "C" const mmverify_subject_t* mmverify_subject_v1() {
  ommBakerCreationDesc desc = ommBakerCreationDescDefault();
  desc.type = ommBakerType_CPU;
  if (baker == nullptr && ommCreateBaker(&desc, &baker) != ommResult_SUCCESS) return nullptr;
  return baker_subject("Opacity Micro-Map SDK", bake, [](mmverify_bake_support_t& it) {
    it.texels = 1U << MMVERIFY_UNORM8, it.filters = 1U << MMVERIFY_BILINEAR,
    it.alpha_modes = 1U << MMVERIFY_MASK;
    it.wraps = ADAPTER_WRAPS;  // border addressing is a subject of its own
    it.restrictions = MMVERIFY_BAKE_SAME_WRAPS | MMVERIFY_BAKE_NO_FACTORS | MMVERIFY_BAKE_NO_MARGIN |
                      MMVERIFY_BAKE_FLOAT_CUTOFFS;
    it.opaque = MMVERIFY_OPAQUE_ABOVE_CUTOFF, it.unknown = MMVERIFY_UNKNOWN_OPAQUE;
    it.uv_min = -16, it.uv_max = 16, it.weight_bits = 8, it.coordinate_bits = 8;
  });
}
