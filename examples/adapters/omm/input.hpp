// ommCpuBake's input for a case, and its result for as long as it is read.
#pragma once

#include <omm.h>

#include "examples/adapters/mesh.hpp"

inline ommBaker baker = nullptr;

inline bool has_baker() {
  ommBakerCreationDesc desc = ommBakerCreationDescDefault();
  desc.type = ommBakerType_CPU;
  return baker != nullptr || ommCreateBaker(&desc, &baker) == ommResult_SUCCESS;
}

inline ommCpuTexture texture(const mmverify_bake_case_t& c) {
  static thread_local ommCpuTexture made = nullptr;
  if (same_texture_as_before(c)) return made;
  if (made != nullptr) ommCpuDestroyTexture(baker, made);
  std::vector<ommCpuTextureMipDesc> mips;
  each_mip(c, [&](uint32_t w, uint32_t h, const uint8_t* texels) { mips.push_back({w, h, w, texels}); });
  const ommCpuTextureDesc desc = {ommCpuTextureFormat_UNORM8, {}, mips.data(), c.mips, -1};
  made = nullptr;
  return ommCpuCreateTexture(baker, &desc, &made) == ommResult_SUCCESS ? made : nullptr;
}

inline ommCpuBakeInputDesc input_of(const mmverify_bake_case_t& c, const float* uvs, const uint32_t* indices,
                                    uint32_t count) {
  ommCpuBakeInputDesc in = ommCpuBakeInputDescDefault();
  in.texture = texture(c), in.texCoords = uvs, in.indexBuffer = indices, in.indexCount = count;
  in.bakeFlags = ommCpuBakeFlags_Force32BitIndices, in.alphaMode = ommAlphaMode_Test;
  in.alphaCutoff = float(double(c.cutoff_numerator) / c.cutoff_denominator);
  in.runtimeSamplerDesc = {ommTextureAddressMode(c.wrap_u), ommTextureFilterMode_Linear,
                           float(c.border) / 255};
  in.texCoordFormat = ommTexCoordFormat_UV32_FLOAT, in.indexFormat = ommIndexFormat_UINT_32;
  in.dynamicSubdivisionScale = 0, in.maxSubdivisionLevel = uint8_t(c.level), in.format = ommFormat(c.format);
  return in;
}

/// The baker's result; false if it refused.
class Baked {
 public:
  explicit Baked(const ommCpuBakeInputDesc& in) {
    if (in.texture != nullptr && ommCpuBake(baker, &in, &result_) == ommResult_SUCCESS)
      ommCpuGetBakeResultDesc(result_, &desc_);
  }
  Baked(const Baked&) = delete;
  Baked& operator=(const Baked&) = delete;
  ~Baked() {
    if (desc_ != nullptr) ommCpuDestroyBakeResult(result_);
  }
  explicit operator bool() const { return desc_ != nullptr; }
  const ommCpuBakeResultDesc* operator->() const { return desc_; }

 private:
  ommCpuBakeResult result_ = nullptr;
  const ommCpuBakeResultDesc* desc_ = nullptr;
};
