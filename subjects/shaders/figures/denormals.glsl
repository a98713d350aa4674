// The bits of u v, which are a denormal's where the product is below 2^-126.
uint index(uint level, float u, float v) {
  precise float product = u * v;
  return floatBitsToUint(product);
}
