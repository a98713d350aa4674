/* A shared library that is no subject, or one from the future, chosen by FAULT when it is compiled. */
#include "subjects/sdk/mmverify_subject.h"

#if FAULT == 1
const mmverify_subject_t* mmverify_subject_v1(void) {
  static mmverify_subject_t subject;
  subject.abi = MMVERIFY_SUBJECT_ABI + 1;
  return &subject;
}
#elif FAULT == 2
const mmverify_subject_t* mmverify_subject_v1(void) {
  static mmverify_subject_t subject;
  subject.abi = MMVERIFY_SUBJECT_ABI;
  subject.size = sizeof subject;
  return &subject;
}
#else
int mmverify_nothing(void);
int mmverify_nothing(void) { return 0; }
#endif
