/** What the function under test is called in verdicts. */
export const subjectName = "your-index.js";
