// The page that viewer/ builds, as it is: from washtub_template to washtub_template_end.
  .section .rodata
  .global washtub_template, washtub_template_end
washtub_template:
  .incbin WASHTUB_TEMPLATE
washtub_template_end:
  .section .note.GNU-stack, "", %progbits
