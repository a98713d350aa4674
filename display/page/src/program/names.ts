/** What the function under test is called in verdicts, as --subject takes it. */
export const subjectName = "./your-index.js";
/** The program wants a file of that name; what it asks is the function. */
export const subjectFile = "/your-index.js";
