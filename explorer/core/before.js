// The explorer's core: microslipCore(options) promises { answer(text), put(name, bytes) }. All of it is in this one function, so
// that a page may start it in a Worker made of its text.
function microslipCore(options) {
